// The sub-pixel grid and the guard band of an image, the same for device and reference.
#pragma once

#include <algorithm>

namespace morphcl {

// Sub-pixel coordinates are ndc * scale + offset, 256 a pixel, y downwards. Triangles are clipped where |x| exceeds
// guard_x * w, so that snapped coordinates stay within 2^23 sub-pixels and edge functions within 64 bits.
struct RasterGrid {
  float scale_x, offset_x, scale_y, offset_y;
  float guard_x, guard_y;

  RasterGrid(int width, int height)
      : scale_x(static_cast<float>(width) * 128.0f),
        offset_x(scale_x),
        scale_y(static_cast<float>(height) * -128.0f),
        offset_y(-scale_y),
        guard_x(guard(offset_x)),
        guard_y(guard(offset_y)) {}

 private:
  // The largest factor for which half_size * (factor + 1) <= 2^23, at most 4096 so that tiny images do not overflow w.
  static float guard(float half_size) { return std::min(8388608.0f / half_size - 1.0f, 4096.0f); }
};

}  // namespace morphcl
