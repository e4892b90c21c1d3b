// The hash of a PNG file's pixels, as morphcl/png.hpp defines it.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "host/image/pixel_hash.hpp"

namespace morphcl {

class PngPixelHasher {
 public:
  PngPixelHasher(std::uint32_t width, std::uint32_t height, int bits) {
    const std::array<std::uint32_t, 3> shape{width, height, static_cast<std::uint32_t>(bits)};
    hasher_.add_row(shape.data(), sizeof shape);
  }
  // Whole lines, as a PNG file has them once they are not filtered any more.
  void add(std::span<const std::uint8_t> lines) { hasher_.add_row(lines.data(), lines.size()); }
  std::string hex() const { return hasher_.hex(); }

 private:
  PixelHasher hasher_;
};

}  // namespace morphcl
