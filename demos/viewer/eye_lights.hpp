// Lights that keep their place before the eye while it moves.
#pragma once

#include <cstdint>
#include <vector>

#include "morphcl/timeline.hpp"

namespace morphcl::viewer {

// The lights of `timeline` at `frame` as `camera` has to see them for its picture to be lit as that of the timeline's
// own camera: directions turned with it, positions moved. Throws what evaluate() throws.
std::vector<Light> lights_before_eye(const Timeline& timeline, std::int64_t frame, const Camera& camera);

}  // namespace morphcl::viewer
