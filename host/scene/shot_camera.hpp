// The [camera] table of a shot file.
#pragma once

#include "anim/timeline.hpp"
#include "host/scene/shot_track.hpp"
#include "host/scene/shot_value.hpp"

namespace morphcl {

Camera read_camera(const ShotValue& camera, TrackReader& tracks);

}  // namespace morphcl
