// The channels of a FrameBuffer as OpenEXR sees them.
#pragma once

#include <ImfFrameBuffer.h>

#include <array>

#include "morphcl/frame.hpp"

namespace morphcl {

inline constexpr std::array<const char*, 4> color_channel_names{"R", "G", "B", "A"};  // in FrameBuffer's order
inline constexpr const char* depth_channel_name = "Z";

// Slices on the channels of `frame`, whose pixel (0, 0) is (first_x, first_y) of the file's data window. A channel that
// a file lacks is read as 0, A as 1.
Imf::FrameBuffer planes_of(FrameBuffer& frame, int first_x, int first_y);

// The same of the whole frame for a writer, which only reads them.
Imf::FrameBuffer planes_to_write(const FrameBuffer& frame);

}  // namespace morphcl
