// One frame as an OpenEXR file: written whole or not at all, read back with every check.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <string>

#include "host/image/frame_buffer.hpp"

namespace morphcl {

// Attributes of a frame. No date, host or path: two runs give the same bytes.
struct FrameAttributes {
  std::int64_t frame = 0;
  std::int64_t fps_numerator = 25, fps_denominator = 1;
  glm::dmat4 world_to_eye{1.0};  // stored as worldToCamera in EXR's own convention (z along the view)
  glm::dmat4 world_to_ndc{1.0};  // stored as worldToNDC: (0, 0) upper left, (1, 1) lower right
  std::string fingerprint;       // of the shot and the settings; a resumed job trusts only frames with its own
};

// xxh3-128 in hex over, channel by channel in alphabetical order: name, type, the window, the rows' values.
std::string pixel_hash(const FrameBuffer& frame);

// Writes to a temporary name in the same folder, flushes to disk, renames. Returns the pixel hash, which the file holds.
// Error(cannot_create) when the folder or the file cannot be made, Error(write_failed) when the disk is full; in both
// cases nothing is left behind. `compression` is one of compression_names().
std::string write_exr(const std::string& path, const FrameBuffer& frame, const FrameAttributes& attributes,
                      const std::string& compression);

struct ExrFrame {
  FrameBuffer frame;
  FrameAttributes attributes;
  std::string stored_hash;  // empty in a file that is not morphcl's
  std::string hash;         // of the pixels as decoded
};

// Decodes every pixel. Error(cannot_read) when the file is missing, Error(bad_input) when it is damaged.
ExrFrame read_exr(const std::string& path);

// Whether `path` is a whole frame of the job with this fingerprint: decodes it, compares hash and fingerprint. Never throws.
bool is_finished_frame(const std::string& path, const std::string& fingerprint);

}  // namespace morphcl
