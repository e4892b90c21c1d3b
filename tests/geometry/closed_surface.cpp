#include "tests/geometry/closed_surface.hpp"

#include <algorithm>

namespace morphcl::testing {

WeldedSurface weld(const std::vector<glm::vec3>& positions, const std::vector<glm::uvec3>& triangles) {
  WeldedSurface surface;
  std::map<std::array<float, 3>, int> known;
  std::vector<int> welded;
  for (const glm::vec3& p : positions) {
    const auto [entry, is_new] = known.try_emplace({p.x, p.y, p.z}, static_cast<int>(known.size()));
    if (is_new) surface.points.emplace_back(p);
    welded.push_back(entry->second);
  }
  for (const glm::uvec3& t : triangles) {
    const int a = welded[t.x], b = welded[t.y], c = welded[t.z];
    if (a != b && b != c && c != a) surface.triangles.push_back({a, b, c});
  }
  return surface;
}

std::map<std::array<int, 2>, int> directed_edges(const WeldedSurface& surface) {
  std::map<std::array<int, 2>, int> edges;
  for (const auto& t : surface.triangles)
    for (std::size_t i = 0; i < 3; ++i) ++edges[{t[i], t[(i + 1) % 3]}];
  return edges;
}

bool is_closed(const WeldedSurface& surface) {
  const auto edges = directed_edges(surface);
  return std::all_of(edges.begin(), edges.end(), [&](const auto& entry) {
    const auto reverse = edges.find({entry.first[1], entry.first[0]});
    return entry.second == 1 && reverse != edges.end() && reverse->second == 1;
  });
}

int euler_characteristic(const WeldedSurface& surface) {
  std::vector<bool> used(surface.points.size(), false);
  for (const auto& t : surface.triangles)
    for (const int corner : t) used[static_cast<std::size_t>(corner)] = true;
  const int vertices = static_cast<int>(std::count(used.begin(), used.end(), true));
  const int edges = static_cast<int>(directed_edges(surface).size()) / 2;
  return vertices - edges + static_cast<int>(surface.triangles.size());
}

double signed_volume(const WeldedSurface& surface) {
  double six_volumes = 0;
  for (const auto& t : surface.triangles) {
    const auto point = [&](std::size_t corner) { return surface.points[static_cast<std::size_t>(t[corner])]; };
    six_volumes += glm::dot(point(0), glm::cross(point(1), point(2)));
  }
  return six_volumes / 6;
}

}  // namespace morphcl::testing
