#include "morphcl/numerics.hpp"

#include <cstddef>

namespace morphcl {

namespace {

template <typename Visit>
void for_each_edge(std::span<const glm::dvec2> polygon, Visit visit) {
  for (std::size_t i = 0; i < polygon.size(); ++i) visit(polygon[i], polygon[(i + 1) % polygon.size()]);
}

bool lies_on(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& point) {
  const glm::dvec2 low = glm::min(a, b), high = glm::max(a, b);
  const bool in_box = point.x >= low.x && point.x <= high.x && point.y >= low.y && point.y <= high.y;
  return in_box && orientation(a, b, point) == 0;
}

}  // namespace

int winding_number(std::span<const glm::dvec2> polygon, const glm::dvec2& point) {
  int winding = 0;
  for_each_edge(polygon, [&](const glm::dvec2& a, const glm::dvec2& b) {
    const bool upwards = a.y <= point.y && b.y > point.y, downwards = a.y > point.y && b.y <= point.y;
    if (!upwards && !downwards) return;
    const int side = orientation(a, b, point);
    if (upwards && side > 0) ++winding;
    if (downwards && side < 0) --winding;
  });
  return winding;
}

PointPlace place_in_polygon(std::span<const glm::dvec2> polygon, const glm::dvec2& point) {
  bool on_boundary = false;
  for_each_edge(polygon, [&](const glm::dvec2& a, const glm::dvec2& b) { on_boundary |= lies_on(a, b, point); });
  if (on_boundary) return PointPlace::boundary;
  return winding_number(polygon, point) != 0 ? PointPlace::inside : PointPlace::outside;
}

}  // namespace morphcl
