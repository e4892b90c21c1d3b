#include "host/image/pixels_over.hpp"

#include <algorithm>

#include "host/image/srgb.hpp"

namespace morphcl {

namespace {

constexpr std::uint16_t opaque = 0x3c00;
constexpr std::uint8_t full = 255;

}  // namespace

PixelsOver::PixelsOver(Rgb background, const Exposure& exposure)
    : background_(background),
      exposure_(exposure),
      behind_{linear_from_srgb8(background.red), linear_from_srgb8(background.green),
              linear_from_srgb8(background.blue)} {}

void PixelsOver::write(const FrameBuffer& frame, std::span<const PixelSpan> spans, int y, int samples,
                       std::uint8_t* out) const {
  const std::array<std::uint8_t, 65536>& code = exposure_.srgb8();
  const std::array<float, 65536>& value = displayable_from_half();
  const float gain = static_cast<float>(exposure_.gain());
  const auto put = [&out, samples](std::uint8_t red, std::uint8_t green, std::uint8_t blue) {
    out[0] = red;
    out[1] = green;
    out[2] = blue;
    if (samples == 4) out[3] = full;
    out += samples;
  };
  for (const PixelSpan& span : spans) {
    if (span.blank) {
      for (std::size_t i = 0; i < span.count; ++i) put(background_.red, background_.green, background_.blue);
      continue;
    }
    const std::uint16_t* const red = frame.color_row(0, y).data() + span.first;
    const std::uint16_t* const green = frame.color_row(1, y).data() + span.first;
    const std::uint16_t* const blue = frame.color_row(2, y).data() + span.first;
    const std::uint16_t* const alphas = frame.color_row(3, y).data() + span.first;
    for (std::size_t x = 0; x < span.count; ++x) {
      if (alphas[x] == opaque) {
        put(code[red[x]], code[green[x]], code[blue[x]]);
      } else if ((alphas[x] | red[x] | green[x] | blue[x]) == 0) {
        put(background_.red, background_.green, background_.blue);
      } else {
        const float shown = 1 - std::min(value[alphas[x]], 1.0f);
        put(srgb8(value[red[x]] * gain + shown * behind_[0]), srgb8(value[green[x]] * gain + shown * behind_[1]),
            srgb8(value[blue[x]] * gain + shown * behind_[2]));
      }
    }
  }
}

}  // namespace morphcl
