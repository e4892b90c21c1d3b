// Lines of a frame over a colour, as pictures for people have pixels: sRGB codes of 8 bits.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "host/image/blank_spans.hpp"
#include "host/image/exposure.hpp"
#include "morphcl/frame.hpp"

namespace morphcl {

class PixelsOver {
 public:
  PixelsOver(Rgb background, const Exposure& exposure);

  // Writes the width() pixels of line y of a frame with colour: R, G, B, and with `samples` = 4 an A of 255. The
  // frame, its colours times the exposure's gain, is put over the background in linear light, alpha clamped to [0, 1]
  // before it is used; values are clamped, NaN is 0. `spans` are those of the line.
  void write(const FrameBuffer& frame, std::span<const PixelSpan> spans, int y, int samples, std::uint8_t* out) const;

 private:
  Rgb background_;
  Exposure exposure_;
  std::array<float, 3> behind_;  // the background in linear light
};

}  // namespace morphcl
