#include "tests/render/parity.hpp"

#include <fmt/format.h>

#include <bit>

namespace morphcl::test {

::testing::AssertionResult same_pixels(const FrameBuffer& expected, const FrameBuffer& actual) {
  const int width = expected.width(), height = expected.height();
  if (actual.width() != width || actual.height() != height)
    return ::testing::AssertionFailure() << "sizes differ: " << actual.width() << "x" << actual.height();
  std::size_t different = 0;
  ::testing::AssertionResult failure = ::testing::AssertionFailure();
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      bool differs = false;
      for (int c = 0; expected.has_color() && c < 4; ++c)
        if (expected.color_row(c, y)[x] != actual.color_row(c, y)[x]) {
          if (different == 0 && !differs)
            failure << fmt::format("pixel ({}, {}) channel {}: expected half bits {:#06x}, got {:#06x}; ", x, y,
                                   "RGBA"[c], expected.color_row(c, y)[x], actual.color_row(c, y)[x]);
          differs = true;
        }
      if (expected.has_depth() &&
          std::bit_cast<unsigned>(expected.depth_row(y)[x]) != std::bit_cast<unsigned>(actual.depth_row(y)[x])) {
        if (different == 0 && !differs)
          failure << fmt::format("pixel ({}, {}) channel Z: expected {:.9g}, got {:.9g}; ", x, y,
                                 expected.depth_row(y)[x], actual.depth_row(y)[x]);
        differs = true;
      }
      different += differs;
    }
  if (different == 0) return ::testing::AssertionSuccess();
  return failure << different << " pixels differ";
}

std::size_t covered_pixels(const FrameBuffer& frame) {
  std::size_t covered = 0;
  for (int y = 0; y < frame.height(); ++y)
    for (int x = 0; x < frame.width(); ++x) covered += frame.color_row(3, y)[x] != 0;
  return covered;
}

}  // namespace morphcl::test
