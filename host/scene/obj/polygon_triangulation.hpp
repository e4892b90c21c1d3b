// Cutting a polygon into triangles.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace morphcl {

// Clipping ears takes quadratic time: a polygon of more corners than this is refused.
inline constexpr std::size_t max_ear_clipping_corners = 2048;

// Appends corners.size() - 2 triangles, as indices into `corners`, wound like the polygon. At least three corners, all
// finite.
//
// Convex polygons become the fan of corner 0. Others are seen along the axis that their Newell normal is closest to,
// and become a fan where a corner (0 first) sees all others, or have their ears clipped. A polygon that crosses itself
// is covered as far as ears can be found, the rest is a fan. Returns false, and appends nothing, for a polygon of more
// than max_ear_clipping_corners that is no fan. Of n corners an ear is searched for among those that lie within its
// extent along an axis, each looked at once: at most 3 n^2 looks, most often some n log n.
bool triangulate_polygon(std::span<const glm::vec3> corners, std::vector<std::array<std::uint32_t, 3>>& triangles);

}  // namespace morphcl
