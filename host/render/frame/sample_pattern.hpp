// Where the samples of a pixel lie, and how a pixel is put together from them: the same for device and reference.
#pragma once

#include <span>

#include "host/render/frame/kernel_layout.hpp"

namespace morphcl {

// From the pixel's centre, x to the right, y downwards.
struct SampleOffset {
  int x, y;  // 1/16 pixel

  int subpixels_x() const { return x * (1 << SAMPLE_UNIT_BITS); }
  int subpixels_y() const { return y * (1 << SAMPLE_UNIT_BITS); }
  float pixels_x() const { return static_cast<float>(x) * 0x1p-4f; }
  float pixels_y() const { return static_cast<float>(y) * 0x1p-4f; }
};

// Of 1, 2, 4, 8 or 16 samples a pixel, one of sample_counts (scene.hpp). One sample is the centre.
std::span<const SampleOffset> sample_pattern(int samples);

}  // namespace morphcl
