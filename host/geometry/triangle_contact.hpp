// Whether a segment, both its ends belonging to it, has a point of a triangle, exactly. A triangle whose corners are on
// one line is the segment or point that they span; a segment whose ends are equal is a point.
#pragma once

#include "morphcl/collision.hpp"

namespace morphcl {

bool segment_meets_triangle(const Segment3& segment, const Triangle& triangle);

}  // namespace morphcl
