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
  constexpr std::size_t side = FrameBuffer::block_side, tile_side = FrameBuffer::tile_side;
  spans.clear();
  const auto width = static_cast<std::size_t>(frame.width());
  const auto add = [&spans, width](std::size_t first, std::size_t pixels, bool blank) {
    const std::size_t count = std::min(pixels, width - first);
    const bool goes_on = !spans.empty() && spans.back().blank == blank;
    if (goes_on && (!blank || spans.back().count + count <= blank_pixels))
      spans.back().count += count;
    else
      spans.push_back({first, count, blank});
  };
  const int tile_y = block_y * static_cast<int>(side) / static_cast<int>(tile_side);
  for (std::size_t first = 0; first < width; first += tile_side) {
    if (frame.blank(static_cast<int>(first / tile_side), tile_y)) {
      add(first, tile_side, true);
      continue;
    }
    for (std::size_t block = first; block < std::min(first + tile_side, width); block += side)
      add(block, side, frame.blank_block(static_cast<int>(block / side), block_y));
  }
}

}  // namespace morphcl
