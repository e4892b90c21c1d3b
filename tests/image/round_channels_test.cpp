// Z of fewer bits in a frame: within the error, the background exactly, colour and blank blocks left alone.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>

#include "host/image/exr_encode.hpp"
#include "host/image/raw_frame.hpp"
#include "morphcl/error.hpp"
#include "morphcl/numerics.hpp"
#include "tests/image/test_frames.hpp"

namespace morphcl {
namespace {

using namespace image_test;

TEST(RoundDepth, IsRoundMantissasOfEveryPixelButTheBackground) {
  for (const bool noise : {false, true}) {
    const auto make = [&] { return noise ? arbitrary_frame(200, 90, default_channels) : disc_frame(200, 90); };
    const FrameBuffer before = make();
    FrameBuffer frame = make();
    round_depth(frame, 1e-4);
    bool rounds = false;
    for (int y = 0; y < frame.height(); ++y) {
      for (int channel = 0; channel < 4; ++channel)
        EXPECT_TRUE(std::ranges::equal(std::as_const(frame).color_row(channel, y), before.color_row(channel, y)));
      for (std::size_t x = 0; x < 200; ++x) {
        float expected = before.depth_row(y)[x];
        const float exact = expected, found = std::as_const(frame).depth_row(y)[x];
        if (expected != background_depth) round_mantissas({&expected, 1}, mantissa_bits_for(1e-4));
        ASSERT_EQ(std::bit_cast<std::uint32_t>(found), std::bit_cast<std::uint32_t>(expected)) << x << ", " << y;
        if (std::isnormal(exact)) {
          ASSERT_LE(std::abs(double{found} - exact), 1e-4 * std::abs(double{exact})) << exact;
        }
        rounds |= std::isnormal(exact) && found != exact;
      }
    }
    EXPECT_TRUE(rounds);
  }
}

TEST(RoundPosition, IsRoundMantissasOfEveryComponent) {
  const FrameBuffer before = arbitrary_frame(120, 40, every_channel);
  FrameBuffer frame = arbitrary_frame(120, 40, every_channel);
  round_position(frame, 1e-4);
  for (int plane = 0; plane < 3; ++plane)
    for (int y = 0; y < 40; ++y)
      for (std::size_t x = 0; x < 120; ++x) {
        float expected = before.float_row(Channel::position, plane, y)[x];
        round_mantissas({&expected, 1}, mantissa_bits_for(1e-4));
        ASSERT_EQ(std::bit_cast<std::uint32_t>(std::as_const(frame).float_row(Channel::position, plane, y)[x]),
                  std::bit_cast<std::uint32_t>(expected));
      }
  for (int y = 0; y < 40; ++y)  // nothing else is
    EXPECT_TRUE(std::ranges::equal(std::as_const(frame).plane_row(Channel::depth, 0, y),
                                   before.plane_row(Channel::depth, 0, y)));
}

// Every half: the nearest multiple of the step, ties to even, which doubles hold exactly, and within the error.
TEST(RoundNormal, EveryHalfBecomesItsNearestMultiple) {
  for (const double error : {0.1, 0.0625, 1e-2, 1e-3, 2.5e-4, 1e-5, 3e-8}) {
    FrameBuffer frame(256, 256, {Channel::normal});
    const auto bits_at = [](int x, int y) { return static_cast<std::uint16_t>(256 * y + x); };
    for (int y = 0; y < 256; ++y)
      for (int x = 0; x < 256; ++x) frame.half_row(Channel::normal, 1, y)[static_cast<std::size_t>(x)] = bits_at(x, y);
    round_normal(frame, error);
    const double step = step_for(error);
    ASSERT_LE(step / 2, error);
    ASSERT_GT(step, error) << "the next step would be too large";
    for (int y = 0; y < 256; ++y)
      for (int x = 0; x < 256; ++x) {
        const std::uint16_t found = std::as_const(frame).half_row(Channel::normal, 1, y)[static_cast<std::size_t>(x)];
        const double exact = from_half(bits_at(x, y));
        if (!std::isfinite(exact)) {
          ASSERT_EQ(found, bits_at(x, y));
          continue;
        }
        ASSERT_EQ(from_half(found), std::nearbyint(exact / step) * step) << exact << " within " << error;
        ASSERT_EQ(std::signbit(from_half(found)), std::signbit(exact));
        ASSERT_LE(std::abs(from_half(found) - exact), error);
      }
  }
}

TEST(RoundNormal, LeavesAFrameWithoutNormalsAndRefusesWhatIsNoError) {
  FrameBuffer frame = disc_frame(40, 40);
  round_normal(frame, 0.1);
  round_position(frame, 0.1);
  EXPECT_EQ(difference(disc_frame(40, 40), frame), "");
  for (const double error : {0.0, -0.1, 0.11, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_THROW(round_normal(frame, error), Error) << error;
}

TEST(RoundDepth, LeavesBlankBlocksAndTheirNotes) {
  FrameBuffer frame = disc_frame(200, 90);
  round_depth(frame, 1e-3);
  EXPECT_FALSE(frame.blank_block(0, 0)) << "nothing is known of a frame that somebody wrote to";
  make_blank(frame, 3, 2, 0);
  float& inside = [&frame]() -> float& {
    const RawFrame memory(frame);
    return reinterpret_cast<float*>(memory.data + 40 * memory.row_bytes + memory.plane_offset(Channel::depth, 0))[50];
  }();
  inside = 1.2345678f;  // what nobody may look at
  round_depth(frame, 1e-3);
  EXPECT_TRUE(frame.blank_block(3, 2));
  EXPECT_FALSE(frame.blank_block(4, 2));
  EXPECT_EQ(std::as_const(frame).depth_row(40)[50], 1.2345678f);
}

TEST(RoundDepth, LeavesAFrameThatNeedsAllItsBitsOrHasNoDepth) {
  FrameBuffer frame = disc_frame(100, 60), colors = disc_frame(100, 60, {Channel::color});
  round_depth(frame, 1e-8);
  EXPECT_EQ(difference(disc_frame(100, 60), frame), "");
  round_depth(colors, 1e-3);
  EXPECT_EQ(difference(disc_frame(100, 60, {Channel::color}), colors), "");
  EXPECT_THROW(round_depth(frame, 0), Error);
}

TEST(RoundDepth, FilesAreSmallerTheMoreMayBeOff) {
  for (const char* compression : {"zip", "zip:small", "zips", "piz"}) {
    std::size_t last = 0;
    for (const double error : {1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 0.0}) {
      FrameBuffer frame = disc_frame(400, 300);
      if (error != 0) round_depth(frame, error);
      std::vector<char> bytes;
      encode_exr(bytes, frame, {}, compression, 1);
      EXPECT_GT(bytes.size(), last) << compression << " within " << error;
      last = bytes.size();
    }
  }
}

}  // namespace
}  // namespace morphcl
