// A frame to and from the bytes of an OpenEXR file, in memory.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "morphcl/exr.hpp"

namespace morphcl {

// Replaces `bytes` by the file; its capacity is kept. Returns the pixel hash that the file holds. The same frame and
// attributes give the same bytes, whatever `threads` (more than 1: OpenEXR's thread pool helps to compress).
std::string encode_exr(std::vector<char>& bytes, const FrameBuffer& frame, const FrameAttributes& attributes,
                       const std::string& compression, int threads);

// As read_exr, with errors that have no place.
ExrFrame decode_exr(std::span<const char> bytes);

}  // namespace morphcl
