#include "morphcl/projection.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace morphcl {

namespace {

// The pixel of coordinate p in [begin, begin + size). A p just below the end may have been rounded onto it.
std::optional<int> pixel_along(double p, double begin, double size) {
  const double pixel = std::clamp(std::floor(p), std::floor(begin), std::ceil(begin + size) - 1);
  const bool fits = pixel >= std::numeric_limits<int>::min() && pixel <= std::numeric_limits<int>::max();
  if (!fits) return std::nullopt;
  return static_cast<int>(pixel);
}

}  // namespace

glm::dvec2 Viewport::to_pixels(const glm::dvec2& ndc) const {
  return {std::fma(0.5 * (ndc.x + 1), width, x), std::fma(0.5 * (1 - ndc.y), height, y)};
}

glm::dvec2 Viewport::to_ndc(const glm::dvec2& pixels) const {
  return {std::fma(2, (pixels.x - x) / width, -1.0), std::fma(-2, (pixels.y - y) / height, 1.0)};
}

std::optional<glm::ivec2> Viewport::pixel_of(const glm::dvec2& ndc) const {
  const bool inside = ndc.x >= -1 && ndc.x < 1 && ndc.y > -1 && ndc.y <= 1;
  if (!inside) return std::nullopt;
  const glm::dvec2 pixels = to_pixels(ndc);
  const std::optional<int> column = pixel_along(pixels.x, x, width), row = pixel_along(pixels.y, y, height);
  if (!column || !row) return std::nullopt;
  return glm::ivec2(*column, *row);
}

}  // namespace morphcl
