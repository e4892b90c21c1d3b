// What a frame's file says about the frame. No date, host or path: two runs give the same bytes.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <string>

namespace morphcl {

struct FrameAttributes {
  std::int64_t frame = 0;  // stored as imageCounter, and with the rate as timeCode
  // Stored as framesPerSecond; numerator 0 to 2^31 - 1, denominator 1 to 2^31 - 1.
  std::int64_t fps_numerator = 25, fps_denominator = 1;
  // morphcl's convention: column vectors, the eye looks down -z. Stored as worldToCamera: row vectors, +z is the
  // viewing direction.
  glm::dmat4 world_to_eye{1.0};
  // morphcl's convention: x and y from -1 to 1, y up. Stored as worldToNDC: row vectors, (0, 0) is the upper left and
  // (1, 1) the lower right corner. Both matrices give screenWindowCenter and screenWindowWidth.
  glm::dmat4 world_to_ndc{1.0};
  std::string fingerprint;  // of the shot and the settings; a resumed job trusts only frames with its own
};

}  // namespace morphcl
