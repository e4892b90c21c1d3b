// Whether a point lies in a polygon of the plane: exactly, for the coordinates given.
//
// Method: the winding number, counted over edges that are half-open in y, with exact orientations
// (host/math/predicates.hpp); so an edge or corner that two polygons share is never counted twice, and no angles are
// added. A point on the boundary is an answer of its own.
#pragma once

#include <glm/glm.hpp>
#include <span>

namespace morphcl {

enum class PointPlace { outside, inside, boundary };

// The polygon is closed by an edge from its last corner to its first; it may be concave, cross itself or run clockwise.
// Inside is where it winds around the point other than 0 times. Of no corners nothing is inside.
PointPlace place_in_polygon(std::span<const glm::dvec2> polygon, const glm::dvec2& point);

// How many times the polygon runs around a point that is not on its boundary, counter-clockwise counted positive.
int winding_number(std::span<const glm::dvec2> polygon, const glm::dvec2& point);

}  // namespace morphcl
