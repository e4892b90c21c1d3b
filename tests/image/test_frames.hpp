// Frames for tests, and their comparison bit for bit.
#pragma once

#include <cstdint>
#include <string>

#include "morphcl/frame.hpp"

namespace morphcl::image_test {

// Every bit pattern may occur: NaN with payloads, infinities, denormals, -0. The padding is filled as well.
FrameBuffer arbitrary_frame(int width, int height, ChannelSet channels, std::uint64_t seed = 1);

// A smooth opaque disc over a transparent background, with its depth, and something smooth in all other channels: what
// renderers make.
FrameBuffer disc_frame(int width, int height, ChannelSet channels = default_channels);

FrameBuffer uniform_frame(int width, int height, float red, float green, float blue, float alpha);

// Marks a block of 16 x 16 pixels as blank and fills it, if `with` is not 0, with what nobody may look at.
void make_blank(FrameBuffer& frame, int block_x, int block_y, std::uint16_t with);

// "" when size, channels and all bits within the image are the same, else the first difference.
std::string difference(const FrameBuffer& expected, const FrameBuffer& actual);

}  // namespace morphcl::image_test
