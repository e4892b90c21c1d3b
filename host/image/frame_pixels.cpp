#include "morphcl/frame.hpp"

#include <half.h>

#include <algorithm>
#include <array>
#include <span>

#include "host/image/srgb.hpp"
#include "host/image/straight_pixels.hpp"
#include "morphcl/error.hpp"

namespace morphcl {

namespace {

void require_color(const FrameBuffer& frame) {
  if (!frame.has_color()) throw Error(ErrorKind::usage, "", "the colours of a frame without colour; ask for RGBA");
}

template <class T>
std::vector<T> array_of(const FrameBuffer& frame) {
  return std::vector<T>(static_cast<std::size_t>(frame.width()) * static_cast<std::size_t>(frame.height()) * 4);
}

// One channel of one pixel. `behind`: what is shown behind it.
std::uint8_t over(float value, float alpha, float behind) { return srgb8(value + (1 - alpha) * behind); }

std::vector<std::uint8_t> straight_pixels(const FrameBuffer& frame) {
  std::vector<std::uint8_t> pixels = array_of<std::uint8_t>(frame);
  std::vector<PixelSpan> spans;
  const std::size_t line_bytes = static_cast<std::size_t>(frame.width()) * straight_pixel_bytes(8);
  for (int y = 0; y < frame.height(); ++y) {
    if (y % static_cast<int>(FrameBuffer::block_side) == 0)
      find_spans(spans, frame, y / static_cast<int>(FrameBuffer::block_side));
    write_straight_pixels(frame, spans, y, 8, Exposure(), pixels.data() + static_cast<std::size_t>(y) * line_bytes);
  }
  return pixels;
}

}  // namespace

std::vector<float> to_rgba32f(const FrameBuffer& frame) {
  require_color(frame);
  std::vector<float> pixels = array_of<float>(frame);
  const std::size_t width = static_cast<std::size_t>(frame.width());
  for (int y = 0; y < frame.height(); ++y)
    for (int channel = 0; channel < 4; ++channel) {
      const std::span<const std::uint16_t> row = frame.color_row(channel, y);
      float* const out = pixels.data() + static_cast<std::size_t>(y) * width * 4 + channel;
      for (std::size_t x = 0; x < width; ++x) out[4 * x] = imath_half_to_float(row[x]);
    }
  return pixels;
}

std::vector<std::uint8_t> to_srgb8(const FrameBuffer& frame, std::optional<Rgb> background) {
  require_color(frame);
  if (!background) return straight_pixels(frame);
  const std::array<float, 3> behind{linear_from_srgb8(background->red), linear_from_srgb8(background->green),
                                    linear_from_srgb8(background->blue)};
  const auto& code = srgb8_from_half();
  const auto& value = displayable_from_half();
  std::vector<std::uint8_t> pixels = array_of<std::uint8_t>(frame);
  std::uint8_t* out = pixels.data();
  for (int y = 0; y < frame.height(); ++y) {
    const std::span<const std::uint16_t> alphas = frame.color_row(3, y);
    const std::array<std::span<const std::uint16_t>, 3> colors{frame.color_row(0, y), frame.color_row(1, y),
                                                               frame.color_row(2, y)};
    for (std::size_t x = 0; x < alphas.size(); ++x) {
      const float alpha = std::min(value[alphas[x]], 1.0f);
      for (std::size_t channel = 0; channel < 3; ++channel) {
        const std::uint16_t stored = colors[channel][x];
        *out++ = alpha == 1 ? code[stored] : over(value[stored], alpha, behind[channel]);
      }
      *out++ = 255;
    }
  }
  return pixels;
}

}  // namespace morphcl
