// The [[light]] tables of a shot file.
#pragma once

#include "host/scene/shot/shot_track.hpp"
#include "host/scene/shot/shot_value.hpp"
#include "morphcl/timeline.hpp"

namespace morphcl {

Light read_light(const ShotValue& light, TrackReader& tracks);

}  // namespace morphcl
