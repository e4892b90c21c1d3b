#include "demos/viewer/picture.hpp"

#include "host/image/srgb.hpp"
#include "host/image/thumbnail.hpp"

namespace morphcl::viewer {

RgbImage picture_of(const FrameBuffer& frame) {
  const auto& code = srgb8_from_half();
  RgbImage picture(frame.width(), frame.height(), picture_background);
  for (int y = 0; y < frame.height(); ++y) {
    const auto red = frame.color_row(0, y), green = frame.color_row(1, y), blue = frame.color_row(2, y);
    const auto alpha = frame.color_row(3, y);
    for (int x = 0; x < frame.width(); ++x)
      if (alpha[x] != 0) picture.at(x, y) = {code[red[x]], code[green[x]], code[blue[x]]};
  }
  return picture;
}

}  // namespace morphcl::viewer
