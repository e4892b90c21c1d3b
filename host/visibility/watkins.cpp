#include <algorithm>

#include "morphcl/hidden_surfaces.hpp"

namespace morphcl {

namespace {

std::int64_t floor_quotient(std::int64_t a, std::int64_t b) {  // b > 0
  return a / b - (a % b < 0 ? 1 : 0);
}

// The first column whose centre does not lie to the left of the edge's point on the line y, a.y != b.y.
int first_column(const glm::ivec3& a, const glm::ivec3& b, int y) {
  const std::int64_t dy = std::abs(b.y - a.y), turn = b.y > a.y ? 1 : -1;
  // 2 column + 1 >= x with x = numerator / dy.
  const std::int64_t numerator = a.x * dy + turn * (b.x - a.x) * std::int64_t{y - a.y};
  return static_cast<int>(-floor_quotient(dy - numerator, 2 * dy));
}

struct Span {
  int polygon, first, end;
};

// A convex polygon's columns on a row; empty where first >= end.
Span span_of(const std::vector<FlatPolygon>& polygons, int index, int row, int width) {
  const FlatPolygon& polygon = polygons[static_cast<std::size_t>(index)];
  const int y = 2 * row + 1;
  int found = 0, columns[2] = {0, 0};
  for (std::size_t i = 0; i < polygon.corners.size() && polygon.plane.z != 0; ++i) {
    const glm::ivec3 &a = polygon.corners[i], &b = polygon.corners[(i + 1) % polygon.corners.size()];
    const bool crosses = (a.y <= y) != (b.y <= y);
    if (crosses && found < 2) columns[found++] = first_column(a, b, y);
  }
  if (found < 2) return {index, 0, 0};
  return {index, std::max(std::min(columns[0], columns[1]), 0), std::min(std::max(columns[0], columns[1]), width)};
}

class ScanLine {
 public:
  ScanLine(const std::vector<FlatPolygon>& polygons, PolygonPicture& picture, int row)
      : polygons_(polygons), picture_(picture), row_(row) {
    for (std::size_t i = 0; i < polygons.size(); ++i) {
      const Span span = span_of(polygons, static_cast<int>(i), row, picture.width);
      if (span.first < span.end) spans_.push_back(span);
    }
  }

  void resolve() {
    std::vector<int> ends;
    for (const Span& span : spans_) ends.insert(ends.end(), {span.first, span.end});
    std::sort(ends.begin(), ends.end());
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
      std::vector<int> active;
      for (const Span& span : spans_)
        if (span.first <= ends[i] && span.end >= ends[i + 1]) active.push_back(span.polygon);
      if (!active.empty()) resolve(ends[i], ends[i + 1], active);
    }
  }

 private:
  int nearest(const std::vector<int>& active, int column) const {
    int held = -1;
    for (const int i : active)
      if (is_seen_before(polygons_, i, held, column, row_)) held = i;
    return held;
  }

  // All active polygons cover the whole of the interval.
  void resolve(int first, int end, const std::vector<int>& active) {
    const int left = nearest(active, first), right = end - first > 1 ? nearest(active, end - 1) : left;
    if (left == right) {
      for (int column = first; column < end; ++column) picture_.at(column, row_) = left;
      return;
    }
    const int middle = first + (end - first) / 2;
    resolve(first, middle, active);
    resolve(middle, end, active);
  }

  const std::vector<FlatPolygon>& polygons_;
  PolygonPicture& picture_;
  int row_;
  std::vector<Span> spans_;
};

}  // namespace

PolygonPicture watkins_picture(const std::vector<FlatPolygon>& polygons, int width, int height) {
  PolygonPicture picture(width, height);
  for (int row = 0; row < height; ++row) ScanLine(polygons, picture, row).resolve();
  return picture;
}

}  // namespace morphcl
