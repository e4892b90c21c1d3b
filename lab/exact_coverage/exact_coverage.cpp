#include "lab/exact_coverage/exact_coverage.hpp"

#include <fmt/format.h>

#include "morphcl/error.hpp"

namespace morphcl::accuracy {

namespace {

struct Span {
  int first, last;  // pixels
  bool empty() const { return first > last; }
};

Span rows_of(const RasterPolygon& polygon, int height) {
  int low = polygon.corner[0].y, high = low;
  for (int i = 1; i < polygon.corners; ++i) {
    low = std::min(low, polygon.corner[static_cast<std::size_t>(i)].y);
    high = std::max(high, polygon.corner[static_cast<std::size_t>(i)].y);
  }
  return {std::max(low >> layout::subpixel_bits, 0), std::min((high - 1) >> layout::subpixel_bits, height - 1)};
}

// Columns that the polygon may reach in a row of pixels: what its sides take there, and a sub-pixel more.
Span columns_of(const RasterPolygon& polygon, int row, int width) {
  const double top = row * layout::subpixels, bottom = top + layout::subpixels;
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (int i = 0; i < polygon.corners; ++i) {
    const SubPixelPoint& p = polygon.corner[static_cast<std::size_t>(i)];
    const SubPixelPoint& q = polygon.corner[static_cast<std::size_t>(i + 1 == polygon.corners ? 0 : i + 1)];
    if (std::max(p.y, q.y) < top || std::min(p.y, q.y) > bottom) continue;
    for (const double y : {std::clamp<double>(p.y, top, bottom), std::clamp<double>(q.y, top, bottom)}) {
      const double x = p.y == q.y ? p.x : p.x + (y - p.y) / (double{1} * q.y - p.y) * (double{1} * q.x - p.x);
      for (const double end : {x, p.y == q.y ? double{1} * q.x : x}) {
        low = std::min(low, end);
        high = std::max(high, end);
      }
    }
  }
  if (low > high) return {0, -1};
  const double first = std::floor((low - 1) / layout::subpixels), last = std::floor((high + 1) / layout::subpixels);
  return {static_cast<int>(std::max(first, 0.0)), static_cast<int>(std::min(last, width - 1.0))};
}

}  // namespace

ExactCoverage::ExactCoverage(const FramePlan& plan) : plan_(plan), polygons_(raster_polygons(plan)) {
  first_of_row_.assign(static_cast<std::size_t>(plan.height) + 1, 0);
  std::uint64_t work = 0;
  for (const RasterPolygon& polygon : polygons_) {
    const Span rows = rows_of(polygon, plan.height);
    for (int y = rows.first; y <= rows.last; ++y) {
      const Span columns = columns_of(polygon, y, plan.width);
      if (!columns.empty()) work += static_cast<std::uint64_t>(columns.last - columns.first + 1);
      ++first_of_row_[static_cast<std::size_t>(y) + 1];
    }
    if (work > max_work)
      throw Error(ErrorKind::usage, "",
                  fmt::format("the {} triangles and lines of frame {} reach more than {} pixels, which exact coverage "
                              "does not cut; a smaller --size takes less",
                              polygons_.size(), plan.frame, max_work));
  }
  for (std::size_t y = 1; y < first_of_row_.size(); ++y) first_of_row_[y] += first_of_row_[y - 1];
  in_rows_.resize(first_of_row_.back());
  std::vector<std::size_t> next = first_of_row_;
  for (std::uint32_t p = 0; p < polygons_.size(); ++p) {
    const Span rows = rows_of(polygons_[p], plan.height);
    for (int y = rows.first; y <= rows.last; ++y) in_rows_[next[static_cast<std::size_t>(y)]++] = p;
  }
}

void ExactCoverage::for_each_in_row(int y,
                                    const std::function<void(int x, const PixelCoverage<double>&)>& visit) const {
  std::vector<std::vector<const RasterPolygon*>> columns(static_cast<std::size_t>(plan_.width));
  const auto row = static_cast<std::size_t>(y);
  for (std::size_t i = first_of_row_[row]; i < first_of_row_[row + 1]; ++i) {
    const RasterPolygon& polygon = polygons_[in_rows_[i]];
    const Span reached = columns_of(polygon, y, plan_.width);
    for (int x = reached.first; x <= reached.last; ++x) columns[static_cast<std::size_t>(x)].push_back(&polygon);
  }
  PixelCoverage<double> coverage(background_depth_of(plan_));
  for (int x = 0; x < plan_.width; ++x) {
    const auto& here = columns[static_cast<std::size_t>(x)];
    if (!coverage.find(here, x, y))
      throw Error(ErrorKind::usage, "",
                  fmt::format("pixel ({}, {}) of frame {} holds {} triangles and lines, too many to cut it by all; a "
                              "larger --size spreads them",
                              x, y, plan_.frame, here.size()));
    visit(x, coverage);
  }
}

}  // namespace morphcl::accuracy
