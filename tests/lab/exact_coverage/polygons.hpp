// Polygons as the raster has them, for tests.
#pragma once

#include <initializer_list>
#include <vector>

#include "lab/exact_coverage/pixel_coverage.hpp"

namespace morphcl::accuracy::testing {

// Corners in sub-pixels of the picture, turned so that the area is positive; `depth` at each corner.
inline RasterPolygon triangle(std::array<SubPixelPoint, 3> corners, std::array<double, 3> depth,
                              std::uint32_t primitive) {
  if (doubled_area(corners[0], corners[1], corners[2]) < 0) {
    std::swap(corners[1], corners[2]);
    std::swap(depth[1], depth[2]);
  }
  RasterPolygon polygon;
  polygon.corners = 3;
  std::copy(corners.begin(), corners.end(), polygon.corner.begin());
  polygon.plane = corners;
  polygon.depth = depth;
  polygon.order = 8 * std::uint64_t{primitive};
  polygon.primitive = primitive;
  return polygon;
}

struct Share {
  double area = 0, with_x = 0, with_y = 0;
};

// What pixel (x, y) shows: of each polygon by its primitive, then of nothing. Areas add up to one exactly.
template <class Real = double>
std::vector<Share> shares_of(const std::vector<RasterPolygon>& polygons, int x = 0, int y = 0, double background = 0,
                             double* error_bound = nullptr) {
  std::vector<const RasterPolygon*> pointers;
  for (const RasterPolygon& polygon : polygons) pointers.push_back(&polygon);
  PixelCoverage<Real> coverage(background);
  EXPECT_TRUE(coverage.find(pointers, x, y));
  std::vector<Share> shares(polygons.size() + 1);
  CoverageUnits sum = 0;
  for (const SurfacePart& part : coverage.parts()) {
    EXPECT_GT(part.area, 0);
    sum += part.area;
    shares[part.draw == nothing_drawn ? polygons.size() : part.primitive] = {pixels_of(part.area), part.with_x,
                                                                             part.with_y};
  }
  EXPECT_EQ(sum, whole_pixel);
  if (error_bound) *error_bound = coverage.error_bound();
  return shares;
}

}  // namespace morphcl::accuracy::testing
