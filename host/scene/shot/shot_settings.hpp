// The [image] and [frames] tables of a shot file.
#pragma once

#include <optional>
#include <vector>

#include "host/scene/shot/shot_value.hpp"
#include "morphcl/scene.hpp"
#include "morphcl/track.hpp"

namespace morphcl {

ImageSettings read_image_settings(const std::optional<ShotValue>& image);

// The [accuracy] table: pixels, or 0 without one.
double read_accuracy(const std::optional<ShotValue>& accuracy);

struct FrameSettings {
  TimeBase time;
  std::vector<FrameRange> ranges;  // empty: the shot does not say
};
FrameSettings read_frame_settings(const std::optional<ShotValue>& frames);

}  // namespace morphcl
