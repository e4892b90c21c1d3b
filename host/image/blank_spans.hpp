// A line of a frame as runs of pixels that are known to be background and of others, so that who reads the frame leaves
// the memory of the background alone.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "morphcl/frame.hpp"

namespace morphcl {

struct PixelSpan {
  std::size_t first, count;
  bool blank;  // then at most blank_pixels long
};

inline constexpr std::size_t blank_pixels = 1024;
extern const std::array<std::uint16_t, blank_pixels> blank_color;
extern const std::array<float, blank_pixels> blank_depth;

// Replaces `spans` by those of the lines of a row of blocks (FrameBuffer::block_side lines each).
void find_spans(std::vector<PixelSpan>& spans, const FrameBuffer& frame, int block_y);

// The pixels of a span of the line `row`.
inline const std::uint16_t* span_pixels(std::span<const std::uint16_t> row, const PixelSpan& span) {
  return span.blank ? blank_color.data() : row.data() + span.first;
}
inline const float* span_pixels(std::span<const float> row, const PixelSpan& span) {
  return span.blank ? blank_depth.data() : row.data() + span.first;
}

}  // namespace morphcl
