// From eye space to the picture: projections, their windows, viewports and vanishing points.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <optional>
#include <variant>

#pragma GCC visibility push(default)
namespace morphcl {

// ---- window ---------------------------------------------------------------------------------------------------------
//
// The rectangle of the picture's plane that an image shows, and how it is brought to the image's proportions.

struct Window {
  double left = -1, right = 1, bottom = -1, top = 1;  // left < right, bottom < top
};

enum class Fit {
  stretch,   // the window fills the image as it is: x and y are drawn to different scales where the proportions differ
  widen,     // along the axis that falls short, both sides move outwards: all of the window shows, undistorted
  crop,      // along the axis that is too long, both sides move inwards: undistorted, but parts of the window are lost
  adjust_x,  // left and right move, out- or inwards: what is between bottom and top shows, undistorted
  adjust_y,  // bottom and top move, out- or inwards: what is between left and right shows, undistorted
};

enum class ChangedAxis { none, x, y };

struct FittedWindow {
  Window window;
  ChangedAxis changed = ChangedAxis::none;  // the axis that was widened or cropped; the other one keeps its bits
};

// `aspect` is width / height of the image, > 0, and `window` has an area; neither is tested. Both sides move by the
// same amount, so the centre stays.
FittedWindow fitted(const Window& window, Fit fit, double aspect);

// ---- oblique --------------------------------------------------------------------------------------------------------
//
// Parallel projectors that meet the picture's plane at an angle. What lies `d` behind the plane is
// drawn moved by d * (x, y), so the plane itself keeps its true shape.
//
// The shear factors (l cos a, l sin a) are what is stored and computed with, not the angle beta between the projectors
// and the plane: l = cot(beta) turns an error of beta into one 1 / sin^2(beta) times as large. Below 1 degree an angle
// rounded to fp32 would move what lies 1 behind the plane by more than 1e-5, so smaller angles are refused.

struct ObliqueShear {
  double x = 0, y = 0;
};

constexpr double min_beta_degrees = 1;
constexpr double max_oblique_factor = 57.289961630759425;  // cot(1 degree)
constexpr double cavalier_factor = 1, cabinet_factor = 0.5;

// Edges that lead straight away from the viewer are drawn at `direction_degrees`, counter-clockwise from the picture's
// x axis, and `factor` times as long as they are: 1 in cavalier, 1/2 in cabinet, 0 in orthographic projections.
// Error(usage) when the factor is not in [0, max_oblique_factor] or the direction is not finite.
ObliqueShear oblique_shear(double direction_degrees, double factor);

// cot(beta): 1 at 45 degrees, 1/2 at atan(2) = 63.43 degrees. Error(usage) when beta is not in [1, 90] degrees.
double oblique_factor(double beta_degrees);

// From the projectors' direction (a, b, c) in eye space, of any length: (a / c, b / c). Error(usage) when it is not
// finite or runs closer than min_beta_degrees to the picture's plane.
ObliqueShear oblique_shear_along(const glm::dvec3& direction);

// ---- projection -----------------------------------------------------------------------------------------------------
//
// Eye space to clip space.
//
// Eye space is right-handed, the camera looks down -z; clip space is -w <= x, y, z <= w, NDC depth is -1 at near and +1
// at far (convention.hpp has the other conventions). Distances are positive along the view axis.

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
  Fit fit = Fit::widen;
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
  Fit fit = Fit::widen;
};

// Oblique projectors (above). The planes are as for Orthographic. near, far and `plane` are distances along the view
// axis; what lies at the distance `plane` is drawn in its true place.
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
// image; it matters to fields of view and to windows that are to fit. Error(usage) as validate(), for an aspect that is
// not positive and finite, and when an entry overflows.
glm::dmat4 projection_matrix(const Projection& projection, double aspect);

// The same with reversed depth: NDC depth is 1 at near and 0 at far, which keeps its relative precision in floating
// point at every distance. With an infinite far plane depth is near / w, exactly 1 on the near plane.
glm::dmat4 reversed_depth_matrix(const Projection& projection, double aspect);

// The vertical field of view that shows `fovx_degrees`, in (0, 180), across an image of the given width / height.
// Error(usage) for other numbers.
double fovy_from_fovx_degrees(double fovx_degrees, double aspect);

// Central projection from the eye (0, 0, eye_z) onto the plane z = 0, the drawing board's perspective: the image of
// (x, y, z) is eye_z / (eye_z - z) times it. x and y are the picture; z keeps the order of depth and is 0 on the board.
// w = eye_z - z, 0 or of the other sign than eye_z at and behind the eye. Error(usage) when eye_z is 0 or not finite.
glm::dmat4 central_projection(double eye_z);

// Along the view axis.
double near_distance(const Projection& projection);
double far_distance(const Projection& projection);
inline bool is_parallel(const Projection& projection) {
  return std::holds_alternative<Orthographic>(projection) || std::holds_alternative<Oblique>(projection);
}

// The window that an image of this aspect shows; fields of view have it on the plane at distance 1 from the eye.
// Error(usage) as projection_matrix().
FittedWindow fitted_window(const Projection& projection, double aspect);

// ---- viewport -------------------------------------------------------------------------------------------------------
//
// NDC -> viewport -> pixel.
//
// Pixel (0, 0) is the upper left one; pixel centres are at half-integers; y grows downwards. A pixel covers the
// half-open square [i, i+1) x [j, j+1), so NDC u = +1 (right edge) and v = -1 (lower edge) belong to no pixel:
// pixel_of() says so instead of naming the one past the end.

struct Viewport {
  double x = 0, y = 0;           // upper left corner, pixels
  double width = 1, height = 1;  // pixels, > 0

  glm::dvec2 to_pixels(const glm::dvec2& ndc) const;  // x + (u+1)/2 * width, y + (1-v)/2 * height
  glm::dvec2 to_ndc(const glm::dvec2& pixels) const;
  // None outside the half-open viewport, for NaN, and where the pixel's number does not fit into an int.
  std::optional<glm::ivec2> pixel_of(const glm::dvec2& ndc) const;
};

// ---- vanishing point ------------------------------------------------------------------------------------------------
//
// Where the images of all lines along an axis of the world meet.

// Of the x, y and z axes of the world, in NDC; none for an axis whose lines stay parallel in the picture. A point may
// lie far outside of [-1, 1].
using VanishingPoints = std::array<std::optional<glm::dvec2>, 3>;

// `world_to_eye` is rigid. An axis is parallel to the picture when the angle between them is below 2^-40 radians, which
// is what rounding may leave of a right angle: its vanishing point would be 10^12 times the picture's width away. In
// parallel projections there are none.
//
// Method: a line along an axis ends at the axis' point at infinity, so its image is the matrix's column of the axis,
// divided by w.
VanishingPoints vanishing_points(const Projection& projection, double aspect, const glm::dmat4& world_to_eye);

// How many there are: a perspective is called one-, two- or three-point after it.
int count(const VanishingPoints& points);

}  // namespace morphcl
#pragma GCC visibility pop
