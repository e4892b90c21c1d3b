#include "tests/render/parity.hpp"

#include <fmt/format.h>

#include <bit>

namespace morphcl::test {

namespace {

// The bits of a pixel in a plane.
std::uint32_t bits_at(const FrameBuffer& frame, Channel channel, int plane, int x, int y) {
  switch (plane_type(channel)) {
    case PixelType::half:
      return frame.half_row(channel, plane, y)[static_cast<std::size_t>(x)];
    case PixelType::float_:
      return std::bit_cast<std::uint32_t>(frame.float_row(channel, plane, y)[static_cast<std::size_t>(x)]);
    case PixelType::uint:
      break;
  }
  return frame.uint_row(channel, plane, y)[static_cast<std::size_t>(x)];
}

std::string value_of(Channel channel, std::uint32_t bits) {
  if (plane_type(channel) != PixelType::float_) return fmt::format("{:#x}", bits);
  return fmt::format("{:.9g} ({:#010x})", std::bit_cast<float>(bits), bits);
}

}  // namespace

::testing::AssertionResult same_pixels(const FrameBuffer& expected, const FrameBuffer& actual) {
  if (actual.channels() != expected.channels()) return ::testing::AssertionFailure() << "channels differ";
  return same_pixels(expected, actual, expected.channels());
}

::testing::AssertionResult same_pixels(const FrameBuffer& expected, const FrameBuffer& actual, ChannelSet channels) {
  const int width = expected.width(), height = expected.height();
  if (actual.width() != width || actual.height() != height)
    return ::testing::AssertionFailure() << "sizes differ: " << actual.width() << "x" << actual.height();
  std::size_t different = 0;
  ::testing::AssertionResult failure = ::testing::AssertionFailure();
  for (const Channel channel : channels)
    for (int plane = 0; plane < plane_count(channel); ++plane)
      for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
          const std::uint32_t wanted = bits_at(expected, channel, plane, x, y),
                              found = bits_at(actual, channel, plane, x, y);
          if (wanted == found) continue;
          if (different++ == 0)
            failure << fmt::format("pixel ({}, {}) channel {} plane {}: expected {}, got {}; ", x, y, name_of(channel),
                                   plane, value_of(channel, wanted), value_of(channel, found));
        }
  if (different == 0) return ::testing::AssertionSuccess();
  return failure << different << " values differ";
}

std::size_t covered_pixels(const FrameBuffer& frame) {
  std::size_t covered = 0;
  for (int y = 0; y < frame.height(); ++y)
    for (int x = 0; x < frame.width(); ++x) covered += frame.color_row(3, y)[x] != 0;
  return covered;
}

}  // namespace morphcl::test
