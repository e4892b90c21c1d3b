#include "demos/viewer/picture.hpp"

#include "host/image/srgb.hpp"

namespace morphcl::viewer {

RgbImage picture_over_black(const FrameBuffer& frame) {
  const auto& code = srgb8_from_half();
  RgbImage picture(frame.width(), frame.height(), Rgb{});
  for (int y = 0; y < frame.height(); ++y) {
    const std::size_t row = frame.row_pitch() * y;
    const std::uint16_t* red = frame.color(0) + row;
    const std::uint16_t* green = frame.color(1) + row;
    const std::uint16_t* blue = frame.color(2) + row;
    for (int x = 0; x < frame.width(); ++x) picture.at(x, y) = {code[red[x]], code[green[x]], code[blue[x]]};
  }
  return picture;
}

}  // namespace morphcl::viewer
