#include "host/image/blank_spans.hpp"

#include <algorithm>

namespace morphcl {

const std::array<std::uint16_t, blank_pixels> blank_color{};
const std::array<float, blank_pixels> blank_depth = [] {
  std::array<float, blank_pixels> line{};
  line.fill(background_depth);
  return line;
}();

void find_spans(std::vector<PixelSpan>& spans, const FrameBuffer& frame, int block_y) {
  constexpr std::size_t side = FrameBuffer::block_side;
  spans.clear();
  const auto width = static_cast<std::size_t>(frame.width());
  for (std::size_t first = 0; first < width; first += side) {
    const std::size_t count = std::min(side, width - first);
    const bool blank = frame.blank_block(static_cast<int>(first / side), block_y);
    const bool goes_on = !spans.empty() && spans.back().blank == blank;
    if (goes_on && (!blank || spans.back().count + count <= blank_pixels))
      spans.back().count += count;
    else
      spans.push_back({first, count, blank});
  }
}

}  // namespace morphcl
