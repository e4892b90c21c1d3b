#include <algorithm>
#include <bit>

#include "morphcl/hidden_surfaces.hpp"

namespace morphcl {

namespace {

struct Window {
  int column, row, size;
};

class Subdivision {
 public:
  Subdivision(const std::vector<FlatPolygon>& polygons, PolygonPicture& picture)
      : polygons_(polygons), picture_(picture) {}

  void resolve(const Window& window, const std::vector<int>& candidates) {
    if (window.column >= picture_.width || window.row >= picture_.height) return;
    std::vector<int> relevant;
    for (const int i : candidates)
      if (may_touch(i, window)) relevant.push_back(i);
    if (relevant.empty()) return;
    if (window.size == 1) {
      int& held = picture_.at(window.column, window.row);
      for (const int i : relevant)
        if (covers(polygon(i), window.column, window.row) &&
            is_seen_before(polygons_, i, held, window.column, window.row))
          held = i;
      return;
    }
    if (const int front = hides_all_others(relevant, window); front >= 0) return fill(window, front);
    const int half = window.size / 2;
    for (const int dy : {0, half})
      for (const int dx : {0, half}) resolve({window.column + dx, window.row + dy, half}, relevant);
  }

 private:
  const FlatPolygon& polygon(int i) const { return polygons_[static_cast<std::size_t>(i)]; }

  // False only where one edge of the polygon, or its box, has the whole window outside.
  bool may_touch(int i, const Window& window) const {
    const auto& corners = polygon(i).corners;
    if (polygon(i).plane.z == 0) return false;
    for (const int axis : {0, 1}) {
      const int first = 2 * (axis == 0 ? window.column : window.row) + 1, last = first + 2 * (window.size - 1);
      const auto below = [&](const glm::ivec3& corner) { return corner[axis] < first; };
      const auto above = [&](const glm::ivec3& corner) { return corner[axis] > last; };
      if (std::all_of(corners.begin(), corners.end(), below) || std::all_of(corners.begin(), corners.end(), above))
        return false;
    }
    return true;
  }

  template <typename Test>
  static bool at_corners(const Window& window, Test test) {
    const int right = window.column + window.size - 1, top = window.row + window.size - 1;
    return test(window.column, window.row) && test(right, window.row) && test(window.column, top) && test(right, top);
  }

  // The polygon that covers the window, as it does if it covers its corners, and is seen before each other one at all
  // four of them, so everywhere between; -1 if there is none.
  int hides_all_others(const std::vector<int>& relevant, const Window& window) const {
    for (const int i : relevant) {
      if (!at_corners(window, [&](int column, int row) { return covers(polygon(i), column, row); })) continue;
      const auto hides = [&](int other) {
        return other == i || at_corners(window, [&](int column, int row) {
                 return is_seen_before(polygons_, i, other, column, row);
               });
      };
      if (std::all_of(relevant.begin(), relevant.end(), hides)) return i;
    }
    return -1;
  }

  void fill(const Window& window, int value) {
    const int right = std::min(window.column + window.size, picture_.width);
    const int top = std::min(window.row + window.size, picture_.height);
    for (int row = window.row; row < top; ++row)
      for (int column = window.column; column < right; ++column) picture_.at(column, row) = value;
  }

  const std::vector<FlatPolygon>& polygons_;
  PolygonPicture& picture_;
};

}  // namespace

PolygonPicture warnock_picture(const std::vector<FlatPolygon>& polygons, int width, int height) {
  PolygonPicture picture(width, height);
  std::vector<int> all(polygons.size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<int>(i);
  const auto size = std::bit_ceil(static_cast<unsigned>(std::max({width, height, 1})));
  Subdivision(polygons, picture).resolve({0, 0, static_cast<int>(size)}, all);
  return picture;
}

}  // namespace morphcl
