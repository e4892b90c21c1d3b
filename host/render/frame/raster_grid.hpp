// The sub-pixel grid and the guard band of an image, the same for device and reference.
#pragma once

#include <algorithm>

#include "host/render/frame/kernel_layout.hpp"

namespace morphcl {

// Sub-pixel coordinates are ndc * scale + offset, y downwards. Triangles are clipped where |x| exceeds guard_x * w, so
// that snapped coordinates stay within layout::max_subpixel and edge functions within 64 bits.
struct RasterGrid {
  float scale_x, offset_x, scale_y, offset_y;
  float guard_x, guard_y;

  RasterGrid(int width, int height)
      : scale_x(static_cast<float>(width) * half_pixels),
        offset_x(scale_x),
        scale_y(static_cast<float>(height) * -half_pixels),
        offset_y(-scale_y),
        guard_x(guard(offset_x)),
        guard_y(guard(offset_y)) {}

 private:
  static constexpr float half_pixels = layout::half_pixel;  // NDC is 2 wide: a pixel's sub-pixels over 2

  // The largest factor for which half_size * (factor + 1) <= max_subpixel, bounded so that tiny images do not overflow
  // w.
  static float guard(float half_size) { return std::min(layout::max_subpixel / half_size - 1.0f, layout::max_guard); }
};

// Of a pixel's column or row, in sub-pixels.
constexpr int pixel_centre(int pixel) { return pixel * layout::subpixels + layout::half_pixel; }

}  // namespace morphcl
