// NDC -> viewport -> pixel.
//
// Pixel (0, 0) is the upper left one; pixel centres are at half-integers; y grows downwards. A pixel covers the
// half-open square [i, i+1) x [j, j+1), so NDC u = +1 (right edge) and v = -1 (lower edge) belong to no pixel:
// pixel_of() says so instead of naming the one past the end.
#pragma once

#include <glm/glm.hpp>
#include <optional>

namespace morphcl {

struct Viewport {
  double x = 0, y = 0;           // upper left corner, pixels
  double width = 1, height = 1;  // pixels, > 0

  glm::dvec2 to_pixels(const glm::dvec2& ndc) const;  // x + (u+1)/2 * width, y + (1-v)/2 * height
  glm::dvec2 to_ndc(const glm::dvec2& pixels) const;
  // None outside the half-open viewport, for NaN, and where the pixel's number does not fit into an int.
  std::optional<glm::ivec2> pixel_of(const glm::dvec2& ndc) const;
};

}  // namespace morphcl
