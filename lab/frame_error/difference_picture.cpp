#include <algorithm>
#include <cmath>

#include "lab/frame_error/difference_files.hpp"

namespace morphcl::accuracy {

namespace {

constexpr Rgb background{24, 24, 30};

std::uint8_t brightness(float error) {
  constexpr int min_exponent = -34, codes_per_doubling = 6;
  if (!(error > 0)) return 0;
  if (!std::isfinite(error)) return 255;
  return static_cast<std::uint8_t>(std::clamp(codes_per_doubling * (std::ilogb(error) - min_exponent), 0, 255));
}

Rgb mark_of(PixelDifference difference) {
  if (difference == PixelDifference::outline) return {255, 40, 40};
  if (difference == PixelDifference::edge) return {255, 220, 0};
  return {255, 0, 255};
}

}  // namespace

RgbImage difference_picture(const FrameDifference& d) {
  RgbImage image(d.width, d.height, background);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    const float color = std::max({d.red[i], d.green[i], d.blue[i]});
    const std::uint8_t code = brightness(d.has_color ? color : d.depth[i]);
    if (d.shown[i] != 0) image.pixels[i] = {code, code, code};
  }
  for (int y = 0; y < d.height; ++y)
    for (int x = 0; x < d.width; ++x) {
      const auto kind = static_cast<PixelDifference>(
          static_cast<int>(d.mask[static_cast<std::size_t>(y) * static_cast<std::size_t>(d.width) + x]));
      if (kind == PixelDifference::none) continue;
      for (int v = std::max(y - 1, 0); v <= std::min(y + 1, d.height - 1); ++v)
        for (int u = std::max(x - 1, 0); u <= std::min(x + 1, d.width - 1); ++u) image.at(u, v) = mark_of(kind);
    }
  return image;
}

}  // namespace morphcl::accuracy
