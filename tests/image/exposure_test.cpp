#include "host/image/exposure.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "host/image/png_encode.hpp"
#include "host/image/srgb.hpp"
#include "host/image/thumbnail.hpp"
#include "morphcl/numerics.hpp"
#include "tests/image/test_frames.hpp"

namespace morphcl {
namespace {

TEST(Exposure, GainIsAPowerOfTwo) {
  EXPECT_EQ(Exposure().gain(), 1);
  EXPECT_EQ(Exposure(3).gain(), 8);
  EXPECT_EQ(Exposure(-30).gain(), std::ldexp(1.0, -30));
  for (const double stops : {0.5, -0.25, 7.3, -29.9}) {
    const double exact = static_cast<double>(std::exp2(static_cast<long double>(stops)));
    EXPECT_NEAR(Exposure(stops).gain(), exact, std::ldexp(exact, -51)) << stops;
  }
}

TEST(Exposure, OfZeroStopsHasTheUsualCodes) {
  EXPECT_EQ(&Exposure().srgb8(), &srgb8_from_half());
  EXPECT_EQ(&Exposure(0).srgb16(), &srgb16_from_half());
}

// A half times a power of two is a half again, within the range of normal ones.
TEST(Exposure, OfWholeStopsHasTheCodesOfOtherHalves) {
  const Exposure brighter(2), darker(-3);
  for (const double value : {0.001, 0.01, 0.1, 0.2, 0.2499}) {
    const std::uint16_t bits = to_half(value);
    EXPECT_EQ(brighter.srgb8()[bits], srgb8_from_half()[to_half(4 * from_half(bits))]) << value;
    EXPECT_EQ(brighter.srgb16()[bits], srgb16_from_half()[to_half(4 * from_half(bits))]) << value;
    EXPECT_EQ(darker.srgb16()[bits], srgb16_from_half()[to_half(from_half(bits) / 8)]) << value;
  }
  EXPECT_EQ(brighter.srgb8()[to_half(0.3)], 255);
  EXPECT_EQ(darker.srgb8()[to_half(8.0)], 255);
  EXPECT_EQ(brighter.srgb8()[to_half(0.0)], 0);
  EXPECT_EQ(brighter.srgb16()[0x7e00], 0) << "NaN";
  EXPECT_EQ(darker.srgb8()[0xbc00], 0) << "-1";
}

// Opaque, half transparent and clear pixels of 0.25.
FrameBuffer quarter_frame() {
  FrameBuffer frame(3, 1, {Channel::color});
  const double alphas[] = {1.0, 0.5, 0.0};
  for (int x = 0; x < 3; ++x) {
    for (int c = 0; c < 3; ++c) frame.color_row(c, 0)[x] = to_half(0.25 * alphas[x]);
    frame.color_row(3, 0)[x] = to_half(alphas[x]);
  }
  return frame;
}

TEST(Exposure, OfPngFramesLeavesAlphaAlone) {
  std::vector<char> bytes;
  encode_png(bytes, quarter_frame(), {}, 16, 1, Exposure(1));
  const FrameBuffer read = decode_png(bytes).frame;
  EXPECT_NEAR(from_half(read.color_row(0, 0)[0]), 0.5, 1e-3);
  EXPECT_NEAR(from_half(read.color_row(1, 0)[1]), 0.25, 1e-3) << "premultiplied by 0.5";
  EXPECT_NEAR(from_half(read.color_row(3, 0)[1]), 0.5, 1e-3);
  EXPECT_EQ(read.color_row(3, 0)[2], 0);
}

TEST(Exposure, OfPicturesLeavesTheirBackgroundAlone) {
  const FrameBuffer frame = quarter_frame();
  const RgbImage picture = thumbnail(frame, {3, 1}, 2);
  EXPECT_EQ(picture.at(0, 0).red, srgb8(0.5f));
  EXPECT_EQ(picture.at(2, 0), picture_background);
  EXPECT_EQ(thumbnail(frame, {3, 1}).at(0, 0).red, srgb8(0.25f));
}

}  // namespace
}  // namespace morphcl
