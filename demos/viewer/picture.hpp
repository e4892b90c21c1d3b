// What stands on the screen: a frame as 8-bit sRGB.
#pragma once

#include "host/image/png_file.hpp"
#include "morphcl/frame.hpp"

namespace morphcl::viewer {

// The premultiplied linear colour, clamped to [0, 1] and rounded to the nearest sRGB code, over picture_background
// (thumbnail.hpp): what is drawn is opaque.
RgbImage picture_of(const FrameBuffer& frame);

}  // namespace morphcl::viewer
