// The frames that a demo must show, worked out by the reference renderer and without the viewer's code.
#pragma once

#include <cstdint>
#include <string>

#include "host/image/png_file.hpp"
#include "morphcl/frame.hpp"
#include "morphcl/scene.hpp"

namespace morphcl::viewer_test {

// A shot of demos/ as `morphcl render --size WIDTHxHEIGHT` reads it.
Scene demo_scene(const std::string& shot, int width, int height);

// With the scene's channels.
FrameBuffer expected_frame(const Scene& scene, std::int64_t frame);

// Over black, by the formula of IEC 61966-2-1 in double precision.
RgbImage srgb_picture(const FrameBuffer& frame);

// Through libpng's own reader. Throws when the file is no PNG.
RgbImage read_png(const std::string& path);

// "" when the upper left part of `actual`, as large as `expected`, differs nowhere by more than `bound` of 255; else
// one line with the first pixel that does, and how many do.
std::string difference(const RgbImage& actual, const RgbImage& expected, int bound);

}  // namespace morphcl::viewer_test
