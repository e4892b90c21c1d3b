// What stands on the screen: a frame as 8-bit sRGB.
#pragma once

#include "host/image/png_file.hpp"
#include "morphcl/frame.hpp"

namespace morphcl::viewer {

// The frame over black: its premultiplied linear colour, clamped to [0, 1] and rounded to the nearest sRGB code.
RgbImage picture_over_black(const FrameBuffer& frame);

}  // namespace morphcl::viewer
