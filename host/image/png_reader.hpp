// PNG files, chunk by chunk: every length and CRC is checked, pixels are decoded a line at a time. What a file costs is
// bounded by what it holds, whatever it claims.
#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "host/image/exr_stream.hpp"
#include "morphcl/png.hpp"

namespace morphcl {

struct PngVisitor {
  // Before the first line, with what stands before the pixels. False: this is enough, the rest is not read.
  std::function<bool(const PngDescription&)> begin = {};
  // Lines from the top, without their filter, of pictures that are_straight(). Good only once all is read: the
  // checksums stand behind.
  std::function<void(int y, std::span<const std::uint8_t> line)> line = {};
};

// RGBA of 8 or 16 bits, not interlaced, at most FrameBuffer::max_side a side: so a line takes little memory.
bool are_straight(const PngDescription& picture);

// The whole file, with the hash of its pixels; without, where the visitor had enough. Error(bad_input) without a place.
PngDescription read_png_file(SizedInput& input, const PngVisitor& visitor = {});

}  // namespace morphcl
