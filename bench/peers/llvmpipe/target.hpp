// Where the peer draws: half RGBA and 32-bit float depth, and how the pixels come back to the host.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace morphcl::bench {

class RenderTarget {
 public:
  // Bound from then on. Error(no_device) when OpenGL refuses the size or format.
  RenderTarget(int width, int height);

  // Waits for what was drawn and reads half RGBA, four halves a pixel, bottom row first.
  void read_back();
  const std::vector<std::uint16_t>& pixels() const { return pixels_; }

 private:
  int width_, height_;
  std::vector<std::uint16_t> pixels_;
};

}  // namespace morphcl::bench
