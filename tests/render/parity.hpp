// Frames of two renderers, compared bit for bit.
#pragma once

#include <gtest/gtest.h>

#include "morphcl/frame.hpp"

namespace morphcl::test {

// Fails with the number of pixels that differ and, of the first one: where, which channel, expected and actual.
::testing::AssertionResult same_pixels(const FrameBuffer& expected, const FrameBuffer& actual);

// Pixels whose alpha is not 0: a scene that draws nothing proves nothing.
std::size_t covered_pixels(const FrameBuffer& frame);

}  // namespace morphcl::test
