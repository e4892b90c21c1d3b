#include "morphcl/frame.hpp"

#include <gtest/gtest.h>
#include <half.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "host/image/thumbnail.hpp"
#include "morphcl/error.hpp"
#include "tests/image/test_frames.hpp"

namespace morphcl {
namespace {

using namespace image_test;

// round(255 sRGB(linear)) by IEC 61966-2-1, in doubles.
int code_of(double linear) {
  linear = std::clamp(linear, 0.0, 1.0);
  const double encoded = linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
  return static_cast<int>(std::lround(255 * encoded));
}

double linear_of(int code) {
  const double encoded = code / 255.0;
  return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

void set(FrameBuffer& frame, std::size_t x, int y, float red, float green, float blue, float alpha) {
  const float values[4] = {red, green, blue, alpha};
  for (int channel = 0; channel < 4; ++channel) frame.color_row(channel, y)[x] = half(values[channel]).bits();
}

ErrorKind kind_of_failure(const std::function<void()>& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.kind();
  }
  ADD_FAILURE() << "nothing was thrown";
  return ErrorKind::internal;
}

TEST(FramePixels, FloatsAreTheStoredValuesWithoutPadding) {
  const FrameBuffer frame = arbitrary_frame(67, 5, {Channel::color, Channel::depth});
  const std::vector<float> pixels = to_rgba32f(frame);
  ASSERT_EQ(pixels.size(), 67u * 5 * 4);
  bool negative = false, not_a_number = false;
  for (int y = 0; y < 5; ++y)
    for (std::size_t x = 0; x < 67; ++x)
      for (int channel = 0; channel < 4; ++channel) {
        half stored;
        stored.setBits(frame.color_row(channel, y)[x]);
        const float expected = stored, actual = pixels[(static_cast<std::size_t>(y) * 67 + x) * 4 + channel];
        ASSERT_TRUE(actual == expected || (std::isnan(actual) && std::isnan(expected))) << x << ", " << y;
        negative |= actual < 0;
        not_a_number |= std::isnan(actual);
      }
  EXPECT_TRUE(negative && not_a_number) << "values that nobody clamped";
  FrameBuffer one = uniform_frame(1, 1, std::numeric_limits<float>::infinity(), 2, -1, 0.5f);
  EXPECT_EQ(to_rgba32f(one), (std::vector<float>{std::numeric_limits<float>::infinity(), 2, -1, 0.5f}));
}

TEST(FramePixels, CodesOfOpaquePixelsAreThoseOfTheirColours) {
  FrameBuffer frame(70, 3, {Channel::color});
  for (int y = 0; y < 3; ++y)
    for (std::size_t x = 0; x < 70; ++x)
      set(frame, x, y, static_cast<float>(x) / 69, static_cast<float>(y) / 2, 0.2f, 1);
  for (const auto& background : {std::optional<Rgb>(), std::optional<Rgb>(Rgb{200, 100, 50})}) {
    const std::vector<std::uint8_t> pixels = to_srgb8(frame, background);
    ASSERT_EQ(pixels.size(), 70u * 3 * 4);
    for (int y = 0; y < 3; ++y)
      for (std::size_t x = 0; x < 70; ++x) {
        const std::uint8_t* pixel = &pixels[(static_cast<std::size_t>(y) * 70 + x) * 4];
        ASSERT_EQ(pixel[0], code_of(half(static_cast<float>(x) / 69))) << x << ", " << y;
        ASSERT_EQ(pixel[1], code_of(half(static_cast<float>(y) / 2))) << x << ", " << y;
        ASSERT_EQ(pixel[2], code_of(half(0.2f))) << x << ", " << y;
        ASSERT_EQ(pixel[3], 255) << x << ", " << y;
      }
  }
}

// Rounding to half before the code is found costs a twentieth of a code at most.
TEST(FramePixels, ColourIsDividedByAlphaBeforeItIsEncoded) {
  const FrameBuffer frame = uniform_frame(3, 2, 0.25f, 0.125f, 0.0625f, 0.25f);
  for (std::size_t pixel = 0; pixel < 6; ++pixel) {
    const std::vector<std::uint8_t> pixels = to_srgb8(frame);
    EXPECT_EQ(pixels[4 * pixel + 0], 255);
    EXPECT_EQ(pixels[4 * pixel + 1], code_of(0.5));
    EXPECT_EQ(pixels[4 * pixel + 2], code_of(0.25));
    EXPECT_EQ(pixels[4 * pixel + 3], 64) << "alpha is not encoded: round(255 / 4)";
  }
}

TEST(FramePixels, BackgroundIsMixedInLinearLight) {
  const Rgb background{46, 188, 255};
  const std::vector<std::uint8_t> pixels = to_srgb8(uniform_frame(1, 1, 0.25f, 0.125f, 0, 0.25f), background);
  EXPECT_EQ(pixels[0], code_of(0.25 + 0.75 * linear_of(46)));
  EXPECT_EQ(pixels[1], code_of(0.125 + 0.75 * linear_of(188)));
  EXPECT_EQ(pixels[2], code_of(0.75));
  EXPECT_EQ(pixels[3], 255);
  const std::vector<std::uint8_t> blank = to_srgb8(FrameBuffer(1, 1, {Channel::color}), background);
  EXPECT_EQ(blank, (std::vector<std::uint8_t>{46, 188, 255, 255}));
}

TEST(FramePixels, CodesOverTheBackgroundOfPicturesAreThoseOfPictures) {
  const FrameBuffer frame = arbitrary_frame(67, 40, {Channel::color});
  const RgbImage picture = thumbnail(frame, {67, 40});
  const std::vector<std::uint8_t> pixels = to_srgb8(frame, picture_background);
  for (int y = 0; y < 40; ++y)
    for (int x = 0; x < 67; ++x) {
      const std::uint8_t* pixel = &pixels[(static_cast<std::size_t>(y) * 67 + static_cast<std::size_t>(x)) * 4];
      ASSERT_EQ((Rgb{pixel[0], pixel[1], pixel[2]}), picture.at(x, y)) << x << ", " << y;
    }
}

TEST(FramePixels, ValuesOutsideOfZeroToOneAreClamped) {
  constexpr float infinity = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
  FrameBuffer frame(6, 1, {Channel::color});
  set(frame, 0, 0, -1, 2, infinity, 1);
  set(frame, 1, 0, nan, 0.5f, -infinity, 1);
  set(frame, 2, 0, 0.5f, 0.5f, 0.5f, 4);  // alpha is 1 before it divides
  set(frame, 3, 0, 0.5f, infinity, nan, 0.5f);
  set(frame, 4, 0, 1, 1, 1, 0);        // no straight colour has alpha 0 and light
  set(frame, 5, 0, 1, 0.25f, 0, nan);  // NaN is 0
  const auto half_code = static_cast<std::uint8_t>(code_of(0.5));
  EXPECT_EQ(to_srgb8(frame), (std::vector<std::uint8_t>{0,         255,       255,       255,  //
                                                        0,         half_code, 0,         255,  //
                                                        half_code, half_code, half_code, 255,  //
                                                        255,       255,       0,         128,  //
                                                        0,         0,         0,         0,    //
                                                        0,         0,         0,         0}));
  const std::vector<std::uint8_t> over_black = to_srgb8(frame, Rgb{0, 0, 0});
  EXPECT_EQ(std::vector<std::uint8_t>(over_black.begin() + 16, over_black.end()),
            (std::vector<std::uint8_t>{255, 255, 255, 255, 255, static_cast<std::uint8_t>(code_of(0.25)), 0, 255}))
      << "what has light without alpha is added";
}

TEST(FramePixels, FrameWithoutColourIsRefused) {
  const FrameBuffer frame(4, 4, {Channel::depth});
  EXPECT_EQ(kind_of_failure([&] { to_rgba32f(frame); }), ErrorKind::usage);
  EXPECT_EQ(kind_of_failure([&] { to_srgb8(frame); }), ErrorKind::usage);
  EXPECT_EQ(kind_of_failure([&] { to_srgb8(frame, Rgb{}); }), ErrorKind::usage);
}

}  // namespace
}  // namespace morphcl
