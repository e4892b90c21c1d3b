// Vanishing points: where the images of all lines along an axis of the world meet.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <optional>

#include "host/math/projection.hpp"

namespace morphcl {

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
