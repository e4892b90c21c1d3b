#include "host/image/straight_pixels.hpp"

#include <algorithm>
#include <array>
#include <cstring>

#include "host/image/srgb.hpp"

namespace morphcl {

namespace {

constexpr std::uint16_t opaque = 0x3c00;

// The whole number nearest to alpha * codes, the larger one of two. The product is exact: a half has 11 bits.
std::uint32_t alpha_code(float alpha, double codes) {
  return (static_cast<std::uint32_t>(alpha * (2 * codes)) + 1) / 2;
}

std::uint8_t* put(std::uint8_t code, std::uint8_t* out) {
  *out = code;
  return out + 1;
}

std::uint8_t* put(std::uint16_t code, std::uint8_t* out) {
  out[0] = static_cast<std::uint8_t>(code >> 8);
  out[1] = static_cast<std::uint8_t>(code & 0xff);
  return out + 2;
}

void store(std::uint16_t code, std::uint16_t& out) { out = code; }
void store(std::uint16_t code, std::uint8_t& out) { out = srgb8_from_srgb16(code); }

using Colors = std::array<const std::uint16_t*, 3>;

// Code is std::uint8_t or std::uint16_t; `table` has the codes of opaque colours.
template <class Code>
std::uint8_t* write_pixels(const Colors& colors, const std::uint16_t* alphas, std::size_t count,
                           const std::array<Code, 65536>& table, double gain, std::uint8_t* out) {
  constexpr Code max = static_cast<Code>(~Code{0});
  const std::array<float, 65536>& value = displayable_from_half();
  for (std::size_t x = 0; x < count; ++x) {
    std::array<Code, 4> pixel{};
    if (alphas[x] == opaque) {
      pixel = {table[colors[0][x]], table[colors[1][x]], table[colors[2][x]], max};
    } else if (const float alpha = std::min(value[alphas[x]], 1.0f); alpha > 0) {
      for (std::size_t channel = 0; channel < 3; ++channel)
        if (const float color = value[colors[channel][x]]; color > 0)
          store(srgb16_of_ratio(color, alpha, gain), pixel[channel]);
      pixel[3] = static_cast<Code>(alpha_code(alpha, max));
    }
    for (const Code code : pixel) out = put(code, out);
  }
  return out;
}

}  // namespace

void write_straight_pixels(const FrameBuffer& frame, std::span<const PixelSpan> spans, int y, int bits,
                           const Exposure& exposure, std::uint8_t* out) {
  const std::size_t pixel_bytes = straight_pixel_bytes(bits);
  for (const PixelSpan& span : spans) {
    if (span.blank) {
      std::memset(out, 0, span.count * pixel_bytes);
      out += span.count * pixel_bytes;
      continue;
    }
    const Colors colors{frame.color_row(0, y).data() + span.first, frame.color_row(1, y).data() + span.first,
                        frame.color_row(2, y).data() + span.first};
    const std::uint16_t* const alphas = frame.color_row(3, y).data() + span.first;
    out = bits == 8 ? write_pixels(colors, alphas, span.count, exposure.srgb8(), exposure.gain(), out)
                    : write_pixels(colors, alphas, span.count, exposure.srgb16(), exposure.gain(), out);
  }
}

}  // namespace morphcl
