#include "demos/viewer/picture.hpp"

#include <gtest/gtest.h>

#include <string>

#include "host/image/thumbnail.hpp"

namespace morphcl::viewer {
namespace {

struct Coded {
  std::uint16_t half;
  std::uint8_t code;  // round(255 sRGB(value)), worked out by hand from IEC 61966-2-1
};
constexpr Coded kZero{0x0000, 0}, kQuarter{0x3400, 137}, kHalf{0x3800, 188}, kOne{0x3c00, 255}, kTwo{0x4000, 255},
    kMinusOne{0xbc00, 0}, kNan{0x7e00, 0};

TEST(Picture, EveryPixelIsTheCodeOfItsOwnColour) {
  constexpr Coded values[] = {kZero, kQuarter, kHalf, kOne, kTwo, kMinusOne, kNan};
  constexpr int width = 70, height = 5;  // the rows are padded
  FrameBuffer frame(width, height, {Channel::color});
  const auto value = [&](int x, int y, int channel) { return values[(x + 3 * y + 2 * channel) % std::size(values)]; };
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      for (int channel = 0; channel < 3; ++channel) {
        frame.color_row(channel, y)[x] = value(x, y, channel).half;
      }
      frame.color_row(3, y)[x] = kOne.half;
    }
  }
  const RgbImage picture = picture_of(frame);
  ASSERT_EQ(picture.width, width);
  ASSERT_EQ(picture.height, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const Rgb& pixel = picture.at(x, y);
      const std::string where = "pixel " + std::to_string(x) + ", " + std::to_string(y);
      EXPECT_EQ(pixel.red, value(x, y, 0).code) << where;
      EXPECT_EQ(pixel.green, value(x, y, 1).code) << where;
      EXPECT_EQ(pixel.blue, value(x, y, 2).code) << where;
    }
  }
}

TEST(Picture, ShowsTheBackgroundOfPicturesWhereNothingIsDrawn) {
  const FrameBuffer frame(3, 2, {Channel::color});
  EXPECT_EQ(picture_of(frame).at(2, 1), picture_background);
}

}  // namespace
}  // namespace morphcl::viewer
