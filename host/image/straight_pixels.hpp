// Lines of a frame as PNG has pixels: sRGB codes, and alpha that no colour is multiplied by.
#pragma once

#include <cstdint>
#include <span>

#include "host/image/blank_spans.hpp"
#include "host/image/exposure.hpp"
#include "morphcl/frame.hpp"

namespace morphcl {

// Bytes of a pixel: R, G, B, A of `bits` (8 or 16) each.
constexpr std::size_t straight_pixel_bytes(int bits) { return static_cast<std::size_t>(bits) / 2; }

// Writes the width() pixels of line y of a frame with colour; 16 bits with the high byte first. Each code is correctly
// rounded (srgb.hpp): of colour that of the stored colour times the exposure's gain, divided by the stored alpha; of
// alpha that of alpha without an encoding. Alpha is clamped to [0, 1] before it divides; colour is 0 where alpha is 0;
// NaN is 0. `spans` are those of the line.
void write_straight_pixels(const FrameBuffer& frame, std::span<const PixelSpan> spans, int y, int bits,
                           const Exposure& exposure, std::uint8_t* out);

}  // namespace morphcl
