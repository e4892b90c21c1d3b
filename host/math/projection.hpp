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

// Throws Error(usage) naming the parameter when the projection is degenerate or not finite. Mirrored volumes (left >
// right, bottom > top) are refused: they would turn front faces into back faces unseen.
void validate(const Projection& projection);

// The OpenGL-style matrix, each entry within 8u64 relative of the exact one. `aspect` is width / height of the
// image, > 0, and is used by Perspective only. Error(usage) also when an entry overflows.
glm::dmat4 projection_matrix(const Projection& projection, double aspect);

// The same with reversed depth: NDC depth is 1 at near and 0 at far, which keeps its relative precision in floating
// point at every distance. With an infinite far plane depth is near / w, exactly 1 on the near plane.
glm::dmat4 reversed_depth_matrix(const Projection& projection, double aspect);

// The vertical field of view that shows `fovx_degrees`, in (0, 180), across an image of the given width / height.
double fovy_from_fovx_degrees(double fovx_degrees, double aspect);

// Central projection from the eye (0, 0, eye_z) onto the plane z = 0, the drawing board's perspective: the image of
// (x, y, z) is eye_z / (eye_z - z) times it. x and y are the picture; z keeps the order of depth and is 0 on the board.
// w = eye_z - z, 0 or of the other sign than eye_z at and behind the eye. Error(usage) when eye_z is 0 or not finite.
glm::dmat4 central_projection(double eye_z);

double near_distance(const Projection& projection);
double far_distance(const Projection& projection);
inline bool is_parallel(const Projection& projection) { return std::holds_alternative<Orthographic>(projection); }

}  // namespace morphcl
