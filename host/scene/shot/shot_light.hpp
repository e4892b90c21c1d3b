// The [[light]] tables of a shot file.
#pragma once

#include <cstddef>

#include "host/scene/shot/parent_links.hpp"
#include "host/scene/shot/shot_track.hpp"
#include "host/scene/shot/shot_value.hpp"
#include "morphcl/timeline.hpp"

namespace morphcl {

// `index` is the light's place in the timeline: what hangs below a parent.
Light read_light(const ShotValue& light, std::size_t index, TrackReader& tracks, ParentLinks& parents);

}  // namespace morphcl
