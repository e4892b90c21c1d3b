// What covers pixels, as the raster has it: convex polygons with corners on the grid of sub-pixels, each with the plane
// of its depth. Triangles are those that clipping left; a line is the parallelogram that several samples see of it.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "host/render/frame/frame_plan.hpp"

namespace morphcl::accuracy {

struct SubPixelPoint {
  int x, y;  // y downwards
};

// Twice the signed area of from, to, p.
inline std::int64_t doubled_area(const SubPixelPoint& from, const SubPixelPoint& to, const SubPixelPoint& p) {
  return std::int64_t{to.x - from.x} * (p.y - from.y) - std::int64_t{to.y - from.y} * (p.x - from.x);
}

struct RasterPolygon {
  std::array<SubPixelPoint, 4> corner{};  // of positive area
  int corners = 0;                        // 3, or 4 of a line
  std::array<SubPixelPoint, 3> plane{};   // where the depth is known; of positive area
  std::array<double, 3> depth{};          // larger is nearer
  std::uint64_t order = 0;                // of equal depths the smaller one is seen
  std::uint32_t draw = 0, primitive = 0;

  double min_depth() const { return std::min({depth[0], depth[1], depth[2]}); }
  double max_depth() const { return std::max({depth[0], depth[1], depth[2]}); }
};

// Those that may touch the image. Depth is what the plan's depth buffer interpolates, before it is rounded: near /
// distance, in parallel projections minus the distance, or the normalized depth of forward buffers.
std::vector<RasterPolygon> raster_polygons(const FramePlan& plan);

// The depth from which on nothing is seen; what lies exactly there is.
double background_depth_of(const FramePlan& plan);

}  // namespace morphcl::accuracy
