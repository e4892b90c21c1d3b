// A frame's file with the attributes of another frame.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "morphcl/exr.hpp"

namespace morphcl {

// Replaces `bytes` by the file `source` with other attributes: its channels, its compressed pixels and its pixel hash
// are kept as they are, nothing is decoded. `source` is what encode_exr made, unchanged: where it comes from a disk,
// compare it with a hash of what was written there. Returns the pixel hash. Error(internal) when it is something else.
std::string relabel_exr(std::vector<char>& bytes, std::span<const char> source, const FrameAttributes& attributes);

}  // namespace morphcl
