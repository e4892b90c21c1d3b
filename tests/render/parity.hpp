// Frames of two renderers, compared bit for bit.
#pragma once

#include <gtest/gtest.h>

#include "morphcl/frame.hpp"

namespace morphcl::test {

// Fails with the number of values that differ and, of the first one: where, which channel, expected and actual.
::testing::AssertionResult same_pixels(const FrameBuffer& expected, const FrameBuffer& actual);
// The same of some channels that both have.
::testing::AssertionResult same_pixels(const FrameBuffer& expected, const FrameBuffer& actual, ChannelSet channels);

// Pixels whose alpha is not 0: a scene that draws nothing proves nothing.
std::size_t covered_pixels(const FrameBuffer& frame);

}  // namespace morphcl::test
