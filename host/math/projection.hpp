// Projections: eye space to clip space.
//
// Eye space is right-handed, the camera looks down -z; clip space is -w <= x, y, z <= w, NDC depth is -1 at near and +1
// at far (docs/conventions.md names the other conventions as adapters). Distances are positive along the view axis.
#pragma once

#include <glm/glm.hpp>
#include <variant>

namespace morphcl {

// Vertical field of view in degrees, in (0, 180); near > 0; far > near, may be infinity.
struct Perspective {
  double fovy_degrees = 45.0;
  double near = 0.1;
  double far = 100.0;
};

// Six planes: left/right/bottom/top are measured on the near plane; near > 0; far > near, may be infinity.
struct Frustum {
  double left = -1, right = 1, bottom = -1, top = 1, near = 1, far = 100;
};

// Six planes: far > near, both finite, near may be negative (then the volume reaches behind the eye).
struct Orthographic {
  double left = -1, right = 1, bottom = -1, top = 1, near = 0, far = 100;
};

using Projection = std::variant<Perspective, Frustum, Orthographic>;

// Throws Error(usage) naming the parameter when the projection is degenerate or not finite.
void validate(const Projection& projection);

// The OpenGL-style matrix. `aspect` is width / height of the image and is used by Perspective only.
glm::dmat4 projection_matrix(const Projection& projection, double aspect);

double near_distance(const Projection& projection);
double far_distance(const Projection& projection);
inline bool is_parallel(const Projection& projection) { return std::holds_alternative<Orthographic>(projection); }

}  // namespace morphcl
