// On which side a point lies: signs of determinants, exact for the numbers given.
//
// Method: Shewchuk (1997). A floating-point evaluation decides where it is further from 0 than its error bound;
// otherwise all products are formed without rounding and summed as an expansion, whose leading component has the sign
// of the sum. Barring overflow and underflow: coordinates are finite, and 0 or of a size between 1e-90 and 1e90.
#pragma once

#include <glm/glm.hpp>
#include <span>

#pragma GCC visibility push(default)
namespace morphcl {

// 1: counter-clockwise, c lies to the left of the line from a to b; -1: to the right; 0: exactly on it.
int orientation(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c);
int orientation(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) = delete;  // GLM would drop z

// 1: d lies on the side of the plane through a, b, c from which they are seen counter-clockwise; -1: on the other;
// 0: exactly in it, or the three have no plane.
int orientation(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d);

// ---- point in polygon -----------------------------------------------------------------------------------------------
//
// Whether a point lies in a polygon of the plane: exactly, for the coordinates given.
//
// Method: the winding number, counted over edges that are half-open in y, with the exact orientations above; so an edge
// or corner that two polygons share is never counted twice, and no angles are added. A point on the boundary is an
// answer of its own.

enum class PointPlace { outside, inside, boundary };

// The polygon is closed by an edge from its last corner to its first; it may be concave, cross itself or run clockwise.
// Inside is where it winds around the point other than 0 times. Of no corners nothing is inside.
PointPlace place_in_polygon(std::span<const glm::dvec2> polygon, const glm::dvec2& point);

// How many times the polygon runs around a point that is not on its boundary, counter-clockwise counted positive. On
// its boundary: some number.
int winding_number(std::span<const glm::dvec2> polygon, const glm::dvec2& point);

}  // namespace morphcl
#pragma GCC visibility pop
