// On which side a point lies: signs of determinants, exact for the numbers given.
//
// Method: Shewchuk (1997). A floating-point evaluation decides where it is further from 0 than its error bound;
// otherwise all products are formed without rounding and summed as an expansion, whose leading component has the sign
// of the sum. Barring overflow and underflow: coordinates are 0 or of a size between 1e-90 and 1e90.
#pragma once

#include <glm/glm.hpp>

namespace morphcl {

// 1: counter-clockwise, c lies to the left of the line from a to b; -1: to the right; 0: exactly on it.
int orientation(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c);

// 1: d lies on the side of the plane through a, b, c from which they are seen counter-clockwise; -1: on the other;
// 0: exactly in it, or the three have no plane.
int orientation(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d);

}  // namespace morphcl
