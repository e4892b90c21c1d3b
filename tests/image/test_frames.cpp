#include "tests/image/test_frames.hpp"

#include <fmt/format.h>
#include <half.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "host/image/raw_frame.hpp"
#include "lab/accuracy/random.hpp"

namespace morphcl::image_test {

namespace {

template <class T>
std::string row_difference(const char* name, int y, std::span<const T> expected, std::span<const T> actual) {
  for (std::size_t x = 0; x < expected.size(); ++x) {
    using Bits = std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint16_t>;
    const Bits want = std::bit_cast<Bits>(expected[x]), got = std::bit_cast<Bits>(actual[x]);
    if (want != got)
      return fmt::format("channel {} at ({}, {}): bits {:#x} expected, {:#x} found", name, x, y, want, got);
  }
  return "";
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
    for (int plane = 0; frame.has_color() && plane < 4; ++plane) {
      std::byte* const pixels = row + memory.plane_offset(Channel::color, plane);
      std::fill_n(reinterpret_cast<std::uint16_t*>(pixels) + first, side, with);
    }
    if (frame.has_depth()) {
      std::byte* const pixels = row + memory.plane_offset(Channel::depth, 0);
      std::fill_n(reinterpret_cast<float*>(pixels) + first, side, with ? 1.0f : background_depth);
    }
  }
  memory.note(block_x / 4, block_y / 4) |= 1u << (block_y % 4 * 4 + block_x % 4);
}

std::string difference(const FrameBuffer& expected, const FrameBuffer& actual) {
  if (expected.width() != actual.width() || expected.height() != actual.height())
    return fmt::format("{} x {} pixels expected, {} x {} found", expected.width(), expected.height(), actual.width(),
                       actual.height());
  if (expected.channels() != actual.channels()) return "other channels than expected";
  constexpr const char* names[] = {"R", "G", "B", "A"};
  for (int y = 0; y < expected.height(); ++y) {
    for (int channel = 0; expected.has_color() && channel < 4; ++channel) {
      const std::string text =
          row_difference(names[channel], y, expected.color_row(channel, y), actual.color_row(channel, y));
      if (!text.empty()) return text;
    }
    const std::string text = row_difference("Z", y, expected.depth_row(y), actual.depth_row(y));
    if (!text.empty()) return text;
  }
  return "";
}

}  // namespace morphcl::image_test
