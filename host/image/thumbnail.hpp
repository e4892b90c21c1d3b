// A frame as a picture for people.
#pragma once

#include "host/image/png_file.hpp"
#include "morphcl/frame.hpp"

namespace morphcl {

struct PictureSize {
  int width = 1, height = 1;
};

// The largest size of the frame's proportions within the box, never larger than the frame; each side at least 1.
PictureSize fitted_size(PictureSize frame, PictureSize box);

// What every picture of a frame, in a file or in a window, shows where the frame's alpha is 0; sRGB.
inline constexpr Rgb picture_background{46, 46, 50};

// The frame scaled down to `size` (at most the frame's) by the mean over each pixel's area, in linear light and
// premultiplied, times `gain`, over picture_background. Error(usage) when the frame has no colour.
RgbImage thumbnail(const FrameBuffer& frame, PictureSize size, double gain = 1);

}  // namespace morphcl
