// Some of a pixel's samples, and where they lie.
#pragma once

#include <cmath>

#include "host/render/frame/sample_pattern.hpp"

namespace morphcl::reference {

// From a pixel's centre, sub-pixels.
struct SubPixelOffset {
  int x, y;
};

class PixelPart {
 public:
  void add(const SampleOffset& sample) {
    ++samples_;
    sum_x_ += sample.subpixels_x();
    sum_y_ += sample.subpixels_y();
  }
  int samples() const { return samples_; }
  // Their mean, to nearest, ties to even; of all samples of the pixel, `samples_a_pixel`, its centre. Only where there
  // are some.
  SubPixelOffset centroid(int samples_a_pixel) const {
    if (samples_ == samples_a_pixel) return {0, 0};
    return {mean(sum_x_), mean(sum_y_)};
  }

 private:
  int mean(int sum) const {
    return static_cast<int>(std::nearbyint(static_cast<float>(sum) / static_cast<float>(samples_)));
  }

  int samples_ = 0;
  int sum_x_ = 0, sum_y_ = 0;  // of the samples' offsets, sub-pixels
};

}  // namespace morphcl::reference
