// A frame to and from the bytes of a PNG file, in memory.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "host/image/exposure.hpp"
#include "morphcl/png.hpp"

namespace morphcl {

// Replaces `bytes` by the file; its capacity is kept. Returns the pixel hash that the file holds. The same frame and
// attributes give the same bytes, whatever `threads`.
std::string encode_png(std::vector<char>& bytes, const FrameBuffer& frame, const FrameAttributes& attributes, int bits,
                       int threads, const Exposure& exposure = Exposure());

// Replaces `bytes` by a picture of the frame for people: R, G, B of 8 bits over the background, as to_srgb8() has them
// without exposure, and nothing about the frame. Error(usage) when the frame has no colour.
void encode_png_over(std::vector<char>& bytes, const FrameBuffer& frame, Rgb background,
                     const Exposure& exposure = Exposure());

// Replaces `bytes` by the file `source` with other attributes: its pixels and their hash are kept as they are, nothing
// is decoded. `source` is what encode_png made, unchanged: where it comes from a disk, compare it with a hash of what
// was written there. Returns the pixel hash. Error(internal) when it is something else.
std::string relabel_png(std::vector<char>& bytes, std::span<const char> source, const FrameAttributes& attributes);

// As read_png, with errors that have no place.
PngFrame decode_png(std::span<const char> bytes);

}  // namespace morphcl
