#include <half.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "host/image/blank_spans.hpp"
#include "host/image/raw_frame.hpp"
#include "morphcl/frame.hpp"
#include "morphcl/numerics.hpp"

namespace morphcl {

namespace {

// Calls `change` with the pixels of each plane of a channel, but for those of blank blocks: the notes about these stay.
template <class Element, class Change>
void change_pixels(FrameBuffer& frame, Channel channel, Change change) {
  const RawFrame memory(frame);
  std::vector<PixelSpan> spans;
  for (int y = 0; y < frame.height(); ++y) {
    constexpr int side = FrameBuffer::block_side;
    if (y % side == 0) find_spans(spans, frame, y / side);
    std::byte* const row = memory.data + static_cast<std::size_t>(y) * memory.row_bytes;
    for (int plane = 0; plane < plane_count(channel); ++plane) {
      auto* const pixels = reinterpret_cast<Element*>(row + memory.plane_offset(channel, plane));
      for (const PixelSpan& span : spans)
        if (!span.blank) change(std::span(pixels + span.first, span.count));
    }
  }
}

void round_floats(FrameBuffer& frame, Channel channel, double relative_error) {
  const int bits = mantissa_bits_for(relative_error);
  if (!frame.has(channel) || bits == float_mantissa_bits) return;
  const float background = std::bit_cast<float>(background_bits(channel));
  change_pixels<float>(frame, channel, [&](std::span<float> pixels) { round_mantissas(pixels, bits, background); });
}

}  // namespace

void round_depth(FrameBuffer& frame, double relative_error) { round_floats(frame, Channel::depth, relative_error); }

void round_position(FrameBuffer& frame, double relative_error) {
  round_floats(frame, Channel::position, relative_error);
}

// A half is either a multiple of the step already, or smaller than 2^11 steps: then its nearest multiple is a half too,
// and the sum with 1.5 * 2^23 rounds to it, ties to even.
void round_normal(FrameBuffer& frame, double absolute_error) {
  const double exact_step = step_for(absolute_error);
  constexpr double min_half = 0x1p-24;  // of which all halves are multiples
  if (!frame.has(Channel::normal) || exact_step <= min_half) return;
  const auto step = static_cast<float>(exact_step);
  const float steps = 1 / step;
  constexpr float shift = 0x1.8p23f, max_steps = 0x1p11f;
  change_pixels<std::uint16_t>(frame, Channel::normal, [&](std::span<std::uint16_t> pixels) {
    for (std::uint16_t& pixel : pixels) {
      const float scaled = imath_half_to_float(pixel) * steps;
      if (!(std::abs(scaled) < max_steps)) continue;  // NaN as well
      pixel = imath_float_to_half(std::copysign((scaled + shift) - shift, scaled) * step);
    }
  });
}

}  // namespace morphcl
