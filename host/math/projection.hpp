// Projections: eye space to clip space.
//
// Eye space is right-handed, the camera looks down -z; clip space is -w <= x, y, z <= w, NDC depth is -1 at near and +1
// at far (docs/conventions.md names the other conventions as adapters). Distances are positive along the view axis.
#pragma once

#include <glm/glm.hpp>
#include <variant>

#include "host/math/oblique.hpp"
#include "host/math/window.hpp"

namespace morphcl {

// Vertical field of view in degrees, in (0, 180); near > 0; far > near, may be infinity. How much shows to the left and
// right follows from the image's proportions.
struct Perspective {
  double fovy_degrees = 45.0;
  double near = 0.1;
  double far = 100.0;
};

// The same with the field of view across the image; how much shows above and below follows.
struct HorizontalPerspective {
  double fovx_degrees = 45.0;
  double near = 0.1;
  double far = 100.0;
};

// Six planes: left/right/bottom/top are measured on the near plane; near > 0; far > near, may be infinity.
struct Frustum {
  double left = -1, right = 1, bottom = -1, top = 1, near = 1, far = 100;
  Fit fit = Fit::stretch;
};

// The drawing board's perspective: the board stands across the view axis, `board` > 0 in front of the eye, and the
// window is measured on it: what lies on the board is drawn in its true size. near > 0; far > near, may be infinity.
struct CentralProjection {
  double left = -1, right = 1, bottom = -1, top = 1, near = 0.1, far = 100, board = 1;
  Fit fit = Fit::widen;
};

// Six planes: far > near, both finite, near may be negative (then the volume reaches behind the eye).
struct Orthographic {
  double left = -1, right = 1, bottom = -1, top = 1, near = 0, far = 100;
  Fit fit = Fit::stretch;
};

// Parallel projectors that meet the picture's plane at an angle (host/math/oblique.hpp). The planes are as for
// Orthographic; near, far and `plane`, where nothing is moved, are distances along the view axis.
struct Oblique {
  double left = -1, right = 1, bottom = -1, top = 1, near = 0, far = 100;
  ObliqueShear shear{};
  double plane = 0;
  Fit fit = Fit::widen;
};

using Projection = std::variant<Perspective, HorizontalPerspective, Frustum, CentralProjection, Orthographic, Oblique>;

// Throws Error(usage) naming the parameter when the projection is degenerate or not finite. Mirrored volumes (left >
// right, bottom > top) are refused: they would turn front faces into back faces unseen.
void validate(const Projection& projection);

// The OpenGL-style matrix, each entry within 8u64 relative of the exact one. `aspect` is width / height of the
// image, > 0; it matters to fields of view and to windows that are to fit. Error(usage) also when an entry overflows.
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
inline bool is_parallel(const Projection& projection) {
  return std::holds_alternative<Orthographic>(projection) || std::holds_alternative<Oblique>(projection);
}

// The window that an image of this aspect shows; fields of view have it on the plane at distance 1 from the eye.
FittedWindow fitted_window(const Projection& projection, double aspect);

}  // namespace morphcl
