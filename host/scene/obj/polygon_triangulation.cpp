#include "host/scene/obj/polygon_triangulation.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace morphcl {

namespace {

// Twice the signed area. Differences of fp32 coordinates and their products are exact in fp64 unless the coordinates'
// magnitudes lie further apart than 2^26 or so; the sign is then right.
double signed_area(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// Newell's normal: the sum over the sides, right for corners that are not quite in one plane.
glm::dvec3 newell_normal(std::span<const glm::vec3> corners) {
  glm::dvec3 normal(0.0);
  const glm::dvec3 origin(corners[0]);  // near the corners, so that far-away polygons keep their digits
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const glm::dvec3 a = glm::dvec3(corners[i]) - origin, b = glm::dvec3(corners[(i + 1) % corners.size()]) - origin;
    normal += glm::cross(a, b);
  }
  return normal;
}

// The corners without the coordinate of the largest normal component, so that the polygon winds counter-clockwise.
std::vector<glm::dvec2> flatten(std::span<const glm::vec3> corners, const glm::dvec3& normal) {
  const glm::dvec3 size = glm::abs(normal);
  const int dropped = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  int u = (dropped + 1) % 3, v = (dropped + 2) % 3;
  if (normal[dropped] < 0) std::swap(u, v);
  std::vector<glm::dvec2> flat;
  flat.reserve(corners.size());
  for (const glm::vec3& corner : corners) flat.emplace_back(corner[u], corner[v]);
  return flat;
}

bool sees_all(const std::vector<glm::dvec2>& flat, std::size_t from) {
  const std::size_t count = flat.size();
  for (std::size_t i = 1; i + 1 < count; ++i)
    if (!(signed_area(flat[from], flat[(from + i) % count], flat[(from + i + 1) % count]) >= 0)) return false;
  return true;
}

// The corners along one axis, to find those near a triangle.
class SortedCorners {
 public:
  SortedCorners(const std::vector<glm::dvec2>& flat, int axis) {
    std::vector<std::pair<double, std::uint32_t>> sorted;
    sorted.reserve(flat.size());
    for (std::uint32_t i = 0; i < flat.size(); ++i) sorted.emplace_back(flat[i][axis], i);
    std::sort(sorted.begin(), sorted.end());
    for (const auto& [place, corner] : sorted) {
      places_.push_back(place);
      corners_.push_back(corner);
    }
  }

  // Those from low to high.
  std::span<const std::uint32_t> between(double low, double high) const {
    const auto first = std::lower_bound(places_.begin(), places_.end(), low) - places_.begin();
    const auto last = std::upper_bound(places_.begin(), places_.end(), high) - places_.begin();
    return std::span(corners_).subspan(static_cast<std::size_t>(first), static_cast<std::size_t>(last - first));
  }

 private:
  std::vector<double> places_;
  std::vector<std::uint32_t> corners_;
};

class EarClipper {
 public:
  explicit EarClipper(const std::vector<glm::dvec2>& flat)
      : flat_(flat),
        along_x_(flat, 0),
        along_y_(flat, 1),
        previous_(flat.size()),
        next_(flat.size()),
        clipped_(flat.size()),
        searches_(flat.size()) {
    const auto count = static_cast<std::uint32_t>(flat.size());
    for (std::uint32_t i = 0; i < count; ++i) {
      previous_[i] = (i + count - 1) % count;
      next_[i] = (i + 1) % count;
    }
  }

  void clip(std::vector<std::array<std::uint32_t, 3>>& triangles) {
    std::uint32_t at = 0;
    std::size_t left = flat_.size(), without_ear = 0;
    while (left > 3 && without_ear < left) {
      if (!is_ear(at)) {
        at = next_[at];
        ++without_ear;
        continue;
      }
      const std::uint32_t before = previous_[at], after = next_[at];
      triangles.push_back({before, at, after});
      next_[before] = after;
      previous_[after] = before;
      clipped_[at] = true;
      searches_[before].state = Search::fresh;
      searches_[after].state = Search::fresh;
      at = next_[after];  // skipping a corner keeps the triangles from all meeting in one
      --left;
      without_ear = 0;
    }
    for (std::uint32_t second = next_[at]; next_[second] != at; second = next_[second])
      triangles.push_back({at, second, next_[second]});
  }

 private:
  // How far a corner has been looked at as an ear. It is kept until its triangle changes: corners are only ever taken
  // away, so one that stood outside the triangle need not be looked at again.
  struct Search {
    enum { fresh, begun, reflex } state = fresh;
    std::span<const std::uint32_t> others;  // begun: of those that may be in the triangle, the ones still to look at
  };

  void begin(Search& search, const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) const {
    if (!(signed_area(a, b, c) > 0)) {
      search.state = Search::reflex;
      return;
    }
    const glm::dvec2 low = glm::min(a, glm::min(b, c)), high = glm::max(a, glm::max(b, c));
    const auto by_x = along_x_.between(low.x, high.x), by_y = along_y_.between(low.y, high.y);
    search.others = by_x.size() < by_y.size() ? by_x : by_y;
    search.state = Search::begun;
  }

  // Convex, with no other corner inside its triangle or on its new side.
  bool is_ear(std::uint32_t at) {
    const glm::dvec2 &a = flat_[previous_[at]], &b = flat_[at], &c = flat_[next_[at]];
    Search& search = searches_[at];
    if (search.state == Search::fresh) begin(search, a, b, c);
    if (search.state == Search::reflex) return false;
    for (; !search.others.empty(); search.others = search.others.subspan(1)) {
      const std::uint32_t other = search.others.front();
      const glm::dvec2& p = flat_[other];
      if (clipped_[other] || p == a || p == b || p == c) continue;  // a slit to a hole visits its corners twice
      if (signed_area(a, b, p) >= 0 && signed_area(b, c, p) >= 0 && signed_area(c, a, p) >= 0) return false;
    }
    return true;
  }

  const std::vector<glm::dvec2>& flat_;
  const SortedCorners along_x_, along_y_;
  std::vector<std::uint32_t> previous_, next_;
  std::vector<bool> clipped_;
  std::vector<Search> searches_;
};

void add_fan(std::size_t from, std::size_t count, std::vector<std::array<std::uint32_t, 3>>& triangles) {
  for (std::size_t i = 1; i + 1 < count; ++i)
    triangles.push_back({static_cast<std::uint32_t>(from), static_cast<std::uint32_t>((from + i) % count),
                         static_cast<std::uint32_t>((from + i + 1) % count)});
}

}  // namespace

bool triangulate_polygon(std::span<const glm::vec3> corners, std::vector<std::array<std::uint32_t, 3>>& triangles) {
  const std::size_t count = corners.size();
  if (count == 3) {
    triangles.push_back({0, 1, 2});
    return true;
  }
  const std::vector<glm::dvec2> flat = flatten(corners, newell_normal(corners));
  constexpr std::size_t max_fan_trials = 8;
  for (std::size_t from = 0; from < std::min(count, max_fan_trials); ++from)
    if (sees_all(flat, from)) {
      add_fan(from, count, triangles);
      return true;
    }
  if (count > max_ear_clipping_corners) return false;
  EarClipper(flat).clip(triangles);
  return true;
}

}  // namespace morphcl
