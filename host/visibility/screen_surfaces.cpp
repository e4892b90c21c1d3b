#include "host/visibility/screen_surfaces.hpp"

namespace morphcl::visibility {

namespace {

constexpr int half_pixel = subpixels / 2;

std::int64_t floored_quotient(std::int64_t a, std::int64_t b) {  // b > 0
  return a / b - (a % b < 0 ? 1 : 0);
}

bool owns_edge(std::int64_t dx, std::int64_t dy) { return dy < 0 || (dy == 0 && dx > 0); }

// Positive inside, of the edge from `a` to `b`.
std::int64_t edge_value(const glm::ivec2& a, const glm::ivec2& b, std::int64_t x, std::int64_t y) {
  return std::int64_t{b.x - a.x} * (y - a.y) - std::int64_t{b.y - a.y} * (x - a.x);
}

bool has_all_outside(const glm::ivec2& a, const glm::ivec2& b, const std::array<glm::ivec2, 3>& corners) {
  return std::ranges::all_of(corners, [&](const glm::ivec2& c) { return edge_value(a, b, c.x, c.y) <= 0; });
}

}  // namespace

Span covered_columns(const Surface& surface, int y) {
  std::int64_t first = surface.box.first_x, end = surface.box.last_x + 1;
  for (std::size_t i = 0; i < 3; ++i) {
    const glm::ivec2 &a = surface.corner[i], &b = surface.corner[(i + 1) % 3];
    const std::int64_t dx = b.x - a.x, dy = b.y - a.y;
    // At column x the edge's value is at_first - dy * subpixels * x.
    const std::int64_t at_first = edge_value(a, b, half_pixel, std::int64_t{y} * subpixels + half_pixel);
    if (dy == 0) {
      if (owns_edge(dx, dy) ? at_first < 0 : at_first <= 0) return {0, 0};
    } else if (dy < 0) {
      first = std::max(first, -floored_quotient(at_first, -dy * subpixels));  // value >= 0
    } else {
      end = std::min(end, -floored_quotient(-at_first, dy * subpixels));  // value > 0
    }
  }
  return first < end ? Span{static_cast<int>(first), static_cast<int>(end)} : Span{0, 0};
}

WindowRelation relation_to_window(const Surface& surface, const PixelBox& window) {
  if (!surface.box.meets(window)) return WindowRelation::outside;
  const std::int64_t x0 = std::int64_t{window.first_x} * subpixels + half_pixel,
                     x1 = std::int64_t{window.last_x} * subpixels + half_pixel,
                     y0 = std::int64_t{window.first_y} * subpixels + half_pixel,
                     y1 = std::int64_t{window.last_y} * subpixels + half_pixel;
  bool surrounding = true;
  for (std::size_t i = 0; i < 3; ++i) {
    const glm::ivec2 &a = surface.corner[i], &b = surface.corner[(i + 1) % 3];
    const std::int64_t dx = b.x - a.x, dy = b.y - a.y;
    const std::int64_t min_value = owns_edge(dx, dy) ? 0 : 1;
    if (edge_value(a, b, dy > 0 ? x0 : x1, dx > 0 ? y1 : y0) < min_value) return WindowRelation::outside;
    surrounding = surrounding && edge_value(a, b, dy > 0 ? x1 : x0, dx > 0 ? y0 : y1) >= min_value;
  }
  return surrounding ? WindowRelation::surrounding : WindowRelation::crossing;
}

bool are_apart(const Surface& a, const Surface& b) {
  for (std::size_t i = 0; i < 3; ++i)
    if (has_all_outside(a.corner[i], a.corner[(i + 1) % 3], b.corner) ||
        has_all_outside(b.corner[i], b.corner[(i + 1) % 3], a.corner))
      return true;
  return false;
}

bool hides_in_window(const Surface& front, const Surface& back, const PixelBox& window) {
  const double error = front.error + back.error;
  if (front.min > back.max) return true;
  const DepthPlane difference = front.depth - back.depth;
  return difference.at(window.first_x, window.first_y) > error &&
         difference.at(window.last_x, window.first_y) > error && difference.at(window.first_x, window.last_y) > error &&
         difference.at(window.last_x, window.last_y) > error;
}

}  // namespace morphcl::visibility
