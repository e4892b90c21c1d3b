// The [[object.transform]] tables of a shot file.
#pragma once

#include "host/scene/shot/shot_track.hpp"
#include "host/scene/shot/shot_value.hpp"
#include "morphcl/animated_transform.hpp"

namespace morphcl {

// Adds the step of the table, of which any number may have keys in its place.
void read_transform_step(const ShotValue& step, TrackReader& tracks, AnimatedTransform& transform);

}  // namespace morphcl
