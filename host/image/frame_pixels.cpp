#include "morphcl/frame.hpp"

#include <half.h>

#include <span>

#include "host/image/pixels_over.hpp"
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

// Four bytes a pixel; `write` makes a line of them.
template <class Write>
std::vector<std::uint8_t> pixels_by_lines(const FrameBuffer& frame, Write write) {
  std::vector<std::uint8_t> pixels = array_of<std::uint8_t>(frame);
  std::vector<PixelSpan> spans;
  const std::size_t line_bytes = static_cast<std::size_t>(frame.width()) * 4;
  for (int y = 0; y < frame.height(); ++y) {
    if (y % static_cast<int>(FrameBuffer::block_side) == 0)
      find_spans(spans, frame, y / static_cast<int>(FrameBuffer::block_side));
    write(spans, y, pixels.data() + static_cast<std::size_t>(y) * line_bytes);
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
  if (!background)
    return pixels_by_lines(frame, [&frame](const std::vector<PixelSpan>& spans, int y, std::uint8_t* out) {
      write_straight_pixels(frame, spans, y, 8, Exposure(), out);
    });
  const PixelsOver over(*background, Exposure());
  return pixels_by_lines(frame, [&frame, &over](const std::vector<PixelSpan>& spans, int y, std::uint8_t* out) {
    over.write(frame, spans, y, 4, out);
  });
}

}  // namespace morphcl
