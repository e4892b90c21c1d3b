// Where a camera stands and what it looks along: look-at, the views of technical drawing, axonometric views.
#pragma once

#include <glm/glm.hpp>

#pragma GCC visibility push(default)
namespace morphcl {

// ---- look at --------------------------------------------------------------------------------------------------------
//
// World -> eye: the rigid transform of a camera that looks along -z of eye space, y up.
//
// The up vector is repaired: only its part across the view axis is used (Kahan cross products). When it is 0 or closer
// to the view axis than 1e-12 radians, a fixed basis is used instead (the world axis least aligned with the view, ties
// to x, y, z in that order) and `up_replaced` reports it. Otherwise each entry of the rotation is within 16u64 of the
// exact one for the given numbers, however close up and view axis are.

struct LookAt {
  glm::dmat4 world_to_eye;
  glm::dmat4 eye_to_world;  // by transpose, not by elimination
  bool up_replaced = false;
};

// Error(usage) when eye equals target, anything is not finite, or the matrix overflows.
LookAt look_at(const glm::dvec3& eye, const glm::dvec3& target, const glm::dvec3& up);

// From `eye` along `direction`, of any length; Error(usage) when it is 0, or anything is not finite.
LookAt look_along(const glm::dvec3& eye, const glm::dvec3& direction, const glm::dvec3& up);

// ---- principal view -------------------------------------------------------------------------------------------------
//
// The views of technical drawing: world -> eye rotations of exact zeros and ones, to be used with an orthographic
// projection.

// Named after the side that is seen. The world's y is up; front is seen from +z, right from +x, top from +y with -z up.
enum class PrincipalView { front, back, left, right, top, bottom };

// The eye is at the origin: an orthographic near distance may be negative so that the volume reaches behind it.
glm::dmat4 world_to_eye(PrincipalView view);

// ---- axonometric ----------------------------------------------------------------------------------------------------
//
// Orthographic projections of a turned object, named after how the three axes are foreshortened.
//
// World y is up in the picture. Seen along the unit vector n (towards the eye), a length along axis i is drawn
// sqrt(1 - n_i^2) times as long, and the squares of these three factors add up to 2. In an isometric view the three are
// equal, in a dimetric view two, in a trimetric view none.

// Unit vectors of world space at right angles: where the eye is, and what is up; look_along(eye, -towards_eye, up) is
// the camera. Each component is within 8u64. From ratios its square is within 4u64, so one of size n within 2u64 / n.
struct ViewDirection {
  glm::dvec3 towards_eye{0, 0, 1}, up{0, 1, 0};
};

// Azimuth: from +z, 0, towards +x, 90. Elevation: above the xz plane, -90 to 90. Error(usage) for other numbers.
ViewDirection view_from_angles(double azimuth_degrees, double elevation_degrees);

// Lengths along x, y and z are drawn in the ratios given, each 0 or more; their scale does not matter: (1, 1, 1) is the
// isometric view, (1, 1, 0.5) the dimetric one of technical drawing. Seen from x, y, z >= 0. Error(usage) when no view
// has them: the square of none may exceed the sum of the other two.
ViewDirection view_from_ratios(const glm::dvec3& ratios);

// The x axis is drawn `x_degrees` below the horizontal to the right, the z axis `z_degrees` below it to the left, y
// upwards: (30, 30) is the isometric view, (7.18, 41.41) the dimetric one. Error(usage) when one is below 0, or the two
// add up to 90 or more, or both are 0.
ViewDirection view_from_axis_angles(double x_degrees, double z_degrees);

// The same view from another corner: the signs of towards_eye become those of `corner`, whose components are 1 or -1.
// Error(usage) for other numbers.
ViewDirection seen_from_corner(const ViewDirection& view, const glm::dvec3& corner);

ViewDirection view_direction(PrincipalView view);

// How long a unit along x, y and z is drawn: each in [0, 1].
glm::dvec3 foreshortening(const ViewDirection& view);

}  // namespace morphcl
#pragma GCC visibility pop
