#include "tests/image/test_frames.hpp"

#include <fmt/format.h>
#include <half.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "host/image/channel_planes.hpp"
#include "host/image/raw_frame.hpp"
#include "lab/accuracy/random.hpp"

namespace morphcl::image_test {

namespace {

// The bits of a pixel in a row of a plane.
std::uint32_t bits_at(std::span<const std::byte> row, std::size_t bytes, std::size_t x) {
  std::uint32_t bits = 0;
  std::memcpy(&bits, row.data() + x * bytes, bytes);
  return bits;
}

}  // namespace

FrameBuffer arbitrary_frame(int width, int height, ChannelSet channels, std::uint64_t seed) {
  FrameBuffer frame(width, height, channels);
  accuracy::Random random(seed);
  std::byte* const memory = frame.data();
  for (std::size_t i = 0; i < frame.bytes(); i += 2) {
    const auto bits = static_cast<std::uint16_t>(random.bits());
    std::memcpy(memory + i, &bits, sizeof bits);
  }
  return frame;
}

FrameBuffer disc_frame(int width, int height, ChannelSet channels) {
  FrameBuffer frame(width, height, channels);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const auto i = static_cast<std::size_t>(x);
      const double u = (x + 0.5) / width * 2 - 1, v = (y + 0.5) / height * 2 - 1, rest = 0.8 - u * u - v * v;
      const float shade = rest > 0 ? static_cast<float>(std::sqrt(rest)) : 0.0f;
      for (int channel = 0; frame.has_color() && channel < 3; ++channel)
        frame.color_row(channel, y)[i] = half(shade * (0.9f - 0.3f * static_cast<float>(channel))).bits();
      if (frame.has_color()) frame.color_row(3, y)[i] = half(rest > 0 ? 1.0f : 0.0f).bits();
      if (frame.has_depth()) frame.depth_row(y)[i] = rest > 0 ? 5.0f - shade : background_depth;
      for (const Channel other : channels - default_channels)
        for (int plane = 0; plane < plane_count(other); ++plane) {
          const float value = rest > 0 ? static_cast<float>(plane + 1) * shade - static_cast<float>(u) : 0.0f;
          if (plane_type(other) == PixelType::half) frame.half_row(other, plane, y)[i] = half(value).bits();
          if (plane_type(other) == PixelType::float_) frame.float_row(other, plane, y)[i] = value;
          if (plane_type(other) == PixelType::uint) frame.uint_row(other, plane, y)[i] = rest > 0 ? 70'000u : 0u;
        }
    }
  return frame;
}

FrameBuffer uniform_frame(int width, int height, float red, float green, float blue, float alpha) {
  FrameBuffer frame(width, height, {Channel::color});
  const float values[4] = {red, green, blue, alpha};
  for (int y = 0; y < height; ++y)
    for (int channel = 0; channel < 4; ++channel)
      std::ranges::fill(frame.color_row(channel, y), half(values[channel]).bits());
  return frame;
}

void make_blank(FrameBuffer& frame, int block_x, int block_y, std::uint16_t with) {
  const RawFrame memory(frame);
  constexpr std::size_t side = FrameBuffer::block_side;
  const std::size_t first = static_cast<std::size_t>(block_x) * side;
  for (std::size_t y = 0; y < side; ++y) {
    std::byte* const row = memory.data + (static_cast<std::size_t>(block_y) * side + y) * memory.row_bytes;
    for (const Channel channel : frame.channels())
      for (int plane = 0; plane < plane_count(channel); ++plane) {
        const std::size_t bytes = bytes_of(plane_type(channel));
        const std::uint32_t value = with ? with : background_bits(channel);
        for (std::size_t x = first; x < first + side; ++x)
          std::memcpy(row + memory.plane_offset(channel, plane) + x * bytes, &value, bytes);
      }
  }
  memory.note(block_x / 4, block_y / 4) |= 1u << (block_y % 4 * 4 + block_x % 4);
}

std::string difference(const FrameBuffer& expected, const FrameBuffer& actual) {
  if (expected.width() != actual.width() || expected.height() != actual.height())
    return fmt::format("{} x {} pixels expected, {} x {} found", expected.width(), expected.height(), actual.width(),
                       actual.height());
  if (expected.channels() != actual.channels()) return "other channels than expected";
  for (const NamedPlane& plane : named_planes(expected.channels(), ChannelNames::plain))
    for (int y = 0; y < expected.height(); ++y) {
      const auto rows = std::array{expected.plane_row(plane.channel, plane.plane, y),
                                   actual.plane_row(plane.channel, plane.plane, y)};
      const std::size_t bytes = bytes_of(plane_type(plane.channel));
      for (std::size_t x = 0; x < static_cast<std::size_t>(expected.width()); ++x)
        if (bits_at(rows[0], bytes, x) != bits_at(rows[1], bytes, x))
          return fmt::format("{} at ({}, {}): bits {:#x} expected, {:#x} found", plane.name, x, y,
                             bits_at(rows[0], bytes, x), bits_at(rows[1], bytes, x));
    }
  return "";
}

}  // namespace morphcl::image_test
