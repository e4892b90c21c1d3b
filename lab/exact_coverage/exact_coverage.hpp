// The exact coverage of a frame: the share of every pixel that each visible surface has.
//
// What is visible is decided by the geometry that the raster has (raster_polygon.hpp), at every point of the picture
// instead of at samples. Method: the polygons that reach a pixel are laid into it from front to back, each cutting the
// convex cells that are there (pixel_cells.hpp). Plain and slow: a microsecond or some hundred for a pixel with edges.
#pragma once

#include <functional>

#include "lab/exact_coverage/pixel_coverage.hpp"

namespace morphcl::accuracy {

class ExactCoverage {
 public:
  // Pixels of polygons, each counted in every one that reaches it.
  static constexpr std::uint64_t max_work = std::uint64_t{1} << 31;

  // `plan` outlives it. Error(usage) where polygons reach more than max_work pixels in all.
  explicit ExactCoverage(const FramePlan& plan);

  // visit(x, coverage) for the pixels of a row, from left to right; `coverage` holds one at a time. Several threads may
  // do so at once. Error(usage) where one pixel takes too long to cut.
  void for_each_in_row(int y, const std::function<void(int x, const PixelCoverage<double>&)>& visit) const;

  std::size_t polygons() const { return polygons_.size(); }

 private:
  const FramePlan& plan_;
  std::vector<RasterPolygon> polygons_;
  std::vector<std::uint32_t> in_rows_;  // indices of polygons, row by row
  std::vector<std::size_t> first_of_row_;
};

}  // namespace morphcl::accuracy
