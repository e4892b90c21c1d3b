// A frame's colours as plain arrays, for whoever goes on with them elsewhere.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "host/image/frame_buffer.hpp"
#include "host/image/png_file.hpp"

namespace morphcl {

// Both give 4 values a pixel (R, G, B, A), row after row from the top, without padding. Error(usage) when the frame has
// no colour.

// The values as they are stored: linear light, premultiplied by alpha.
std::vector<float> to_rgba32f(const FrameBuffer& frame);

// Codes of 8 bits: colour is sRGB, alpha is linear.
//
// Without a background alpha is straight, as PNG has it: colour is divided by alpha before it is encoded, and is 0
// where alpha is 0. With a background (sRGB) the frame is put over it in linear light, and alpha is 255. Values are
// clamped to 0..1, alpha before it is used; NaN is 0.
std::vector<std::uint8_t> to_srgb8(const FrameBuffer& frame, std::optional<Rgb> background = std::nullopt);

}  // namespace morphcl
