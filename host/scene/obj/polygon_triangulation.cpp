#include "host/scene/obj/polygon_triangulation.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

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

class EarClipper {
 public:
  explicit EarClipper(const std::vector<glm::dvec2>& flat) : flat_(flat), previous_(flat.size()), next_(flat.size()) {
    const auto count = static_cast<std::uint32_t>(flat.size());
    for (std::uint32_t i = 0; i < count; ++i) {
      previous_[i] = (i + count - 1) % count;
      next_[i] = (i + 1) % count;
    }
  }

  // False when the work is not done after 16 looks at a corner for each pair of corners.
  bool clip(std::vector<std::array<std::uint32_t, 3>>& triangles) {
    const std::size_t max_looks = 16 * flat_.size() * flat_.size();
    std::uint32_t at = 0;
    std::size_t left = flat_.size(), without_ear = 0;
    while (left > 3 && without_ear < left) {
      if (looks_ > max_looks) return false;
      if (!is_ear(at)) {
        at = next_[at];
        ++without_ear;
        continue;
      }
      triangles.push_back({previous_[at], at, next_[at]});
      next_[previous_[at]] = next_[at];
      previous_[next_[at]] = previous_[at];
      at = next_[next_[at]];  // skipping a corner keeps the triangles from all meeting in one
      --left;
      without_ear = 0;
    }
    for (std::uint32_t second = next_[at]; next_[second] != at; second = next_[second])
      triangles.push_back({at, second, next_[second]});
    return true;
  }

 private:
  // Convex, with no other corner inside its triangle or on its new side.
  bool is_ear(std::uint32_t at) {
    const std::uint32_t before = previous_[at], after = next_[at];
    const glm::dvec2 &a = flat_[before], &b = flat_[at], &c = flat_[after];
    if (!(signed_area(a, b, c) > 0)) return false;
    for (std::uint32_t other = next_[after]; other != before; other = next_[other]) {
      ++looks_;
      const glm::dvec2& p = flat_[other];
      if (p == a || p == b || p == c) continue;  // a slit to a hole visits its corners twice
      if (signed_area(a, b, p) >= 0 && signed_area(b, c, p) >= 0 && signed_area(c, a, p) >= 0) return false;
    }
    return true;
  }

  const std::vector<glm::dvec2>& flat_;
  std::vector<std::uint32_t> previous_, next_;
  std::size_t looks_ = 0;
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
  const std::size_t before = triangles.size();
  if (EarClipper(flat).clip(triangles)) return true;
  triangles.resize(before);
  return false;
}

}  // namespace morphcl
