#include "morphcl/track.hpp"

#include <cmath>
#include <limits>
#include <vector>

#include "tests/math/check.hpp"

namespace morphcl {
namespace {

constexpr TimeBase pal{25, 1}, ntsc{30000, 1001};

TEST(TimeBase, FrameTicksAreExactToAMillionFrames) {
  for (const TimeBase& time : {pal, ntsc, TimeBase{24000, 1001}, TimeBase{1, 1'000'000}, TimeBase{1'000'000, 1}})
    for (std::int64_t frame = -1'000'000; frame <= 1'000'000; frame += 997) {
      // frame / fps seconds, as a fraction, against ticks / (ticks a second), cross-multiplied.
      __extension__ using Wide = __int128;
      const Wide ticks = time.frame_ticks(frame);
      EXPECT_TRUE(ticks * time.fps_numerator == Wide{frame} * time.fps_denominator * time.ticks_per_second())
          << frame << " at " << time.fps_numerator << "/" << time.fps_denominator;
    }
  EXPECT_EQ(ntsc.frame_ticks(1'000'000), 1'001'000'000'000'000);
}

TEST(TimeBase, SecondsOfAFrameFallOnTheFrame) {
  for (const TimeBase& time : {pal, ntsc, TimeBase{24, 1}})
    for (std::int64_t frame = -100'000; frame <= 1'000'000; frame += 7) {
      const double seconds = static_cast<double>(frame) * static_cast<double>(time.fps_denominator) /
                             static_cast<double>(time.fps_numerator);
      ASSERT_EQ(time.seconds_to_ticks(seconds), time.frame_ticks(frame)) << frame;
      ASSERT_EQ(time.frames_to_ticks(static_cast<double>(frame)), time.frame_ticks(frame)) << frame;
    }
}

TEST(TimeBase, SecondsStoredAsFloatsFallOnTheFrame) {
  for (const TimeBase& time : {pal, ntsc, TimeBase{24, 1}, TimeBase{60, 1}})
    for (std::int64_t frame = 0; frame <= 20'000; ++frame) {
      const auto seconds = static_cast<float>(static_cast<double>(frame) * static_cast<double>(time.fps_denominator) /
                                              static_cast<double>(time.fps_numerator));
      ASSERT_EQ(time.float_seconds_to_ticks(seconds), time.frame_ticks(frame)) << frame;
    }
  // The float beside a frame's is another time.
  const float beside = std::nextafter(1.04f, 2.0f);
  EXPECT_EQ(pal.float_seconds_to_ticks(beside), pal.seconds_to_ticks(static_cast<double>(beside)));
  EXPECT_GT(pal.float_seconds_to_ticks(beside), pal.float_seconds_to_ticks(1.04f));
}

TEST(TimeBase, NearestTickTiesToEven) {
  constexpr TimeBase slow{1, 1'000'000};                    // 10^12 ticks a frame
  EXPECT_EQ(slow.frames_to_ticks(0x1p-13), 122'070'312);    // 122,070,312.5
  EXPECT_EQ(slow.frames_to_ticks(-0x1p-13), -122'070'312);  // ties to even on both sides
  EXPECT_EQ(slow.frames_to_ticks(0x3p-13), 366'210'938);    // 366,210,937.5
  constexpr TimeBase binary{32, 1};                         // 32,000,000 ticks a second
  EXPECT_EQ(binary.seconds_to_ticks(3.0 / 32'000'000), 3);
  EXPECT_EQ(binary.seconds_to_ticks(3.4 / 32'000'000), 3);
  EXPECT_EQ(binary.seconds_to_ticks(3.6 / 32'000'000), 4);
  EXPECT_EQ(binary.seconds_to_ticks(1e-300), 0);
  EXPECT_EQ(binary.seconds_to_ticks(-5e-324), 0);
}

// A product beyond 2^53 keeps every bit: 2^53 - 1 frames would be rounded in fp64.
TEST(TimeBase, LargeTimesKeepEveryTick) {
  constexpr TimeBase unit{1, 1};
  EXPECT_EQ(unit.seconds_to_ticks(4398046511103.0), 4398046511103'000'000);
  EXPECT_EQ(unit.seconds_to_ticks(-4398046511103.0), -4398046511103'000'000);
  EXPECT_EQ(ntsc.seconds_to_ticks(1e7), 300'000'000'000'000'000);
}

TEST(TimeBase, HostileTimesAreErrors) {
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity(), 1e300, -1e300, 1.9e11})
    expect_error([&] { pal.seconds_to_ticks(bad); }, ErrorKind::bad_input, "2^62 ticks");
  expect_error([] { pal.frames_to_ticks(1e13); }, ErrorKind::bad_input, "frames");
  expect_error([] { pal.float_seconds_to_ticks(std::nanf("")); }, ErrorKind::bad_input, "seconds");
}

}  // namespace
}  // namespace morphcl
