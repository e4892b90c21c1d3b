// Where a camera must stand so that points fill its picture and lie in the middle of it.
#pragma once

#include <functional>
#include <glm/glm.hpp>

namespace morphcl {

// The points, in the axes of the eye (x to the right, y upwards, z towards the eye), as their support: of a direction,
// the point that reaches farthest along it.
using Farthest = std::function<glm::dvec3(const glm::dvec3& direction)>;

// From the least to the greatest of a coordinate.
struct Extent {
  double lower, upper;
  double center() const { return 0.5 * lower + 0.5 * upper; }
  double size() const { return upper - lower; }
};
// Of the points' products with `direction`.
Extent extent_along(const Farthest& points, const glm::dvec3& direction);

// The eye's place. `center` and `half` are slopes: a point at distance d before the eye is drawn in the middle when it
// is d * center away from the view axis, and at the edges when it is d * half further; half > 0. The points are drawn
// about the middle, as much on one side of it as on the other, and the nearest eye is taken for which none is drawn
// outside and none is nearer than min_distance along the view.
//
// Method: with center taken out by a shear, a point lies between the edges iff z + |x - e.x| / half <= e.z. So with t =
// 1 / half, a(t) = max(z + x t) and b(t) = max(z - x t), the nearest eye has e.z = h(t) = (a + b) / 2 and e.x = (a - b)
// / 2t, and looks at the middle; of the eyes for x and for y the farther one is taken. Seen from there the points fill
// the other direction between narrower edges, those whose h(t) is this e.z. h is convex, piecewise linear and does not
// fall, so Newton's iteration ends in the root, from above, after finitely many steps.
glm::dvec3 fitted_eye(const Farthest& points, const glm::dvec2& center, const glm::dvec2& half, double min_distance);

}  // namespace morphcl
