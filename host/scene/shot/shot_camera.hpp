// The [camera] table of a shot file.
#pragma once

#include "host/scene/shot/shot_track.hpp"
#include "host/scene/shot/shot_value.hpp"
#include "morphcl/timeline.hpp"

namespace morphcl {

struct ShotCamera {
  Camera camera;
  bool marks_vanishing_points = false;  // host/scene/shot/vanishing_marks.hpp
};
ShotCamera read_camera(const ShotValue& camera, TrackReader& tracks);

}  // namespace morphcl
