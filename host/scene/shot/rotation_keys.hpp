// Rotation keys of a shot's track.
//
// A rotation is written as a quaternion [x, y, z, w] of any length but 0, or as { axis = [x, y, z], degrees = d },
// counter- clockwise seen from the tip of the axis. Between two keys a track turns along the shorter arc, except that
// linear keys which turn about the same axis turn the whole way from one angle to the other, through as many turns as
// that is.
#pragma once

#include <cstddef>
#include <vector>

#include "host/scene/shot/track_key.hpp"

namespace morphcl {

// Fills key.value, a unit quaternion x y z w, and key.turn.
void read_rotation(const ShotValue& value, TrackKey& key);

// How many keys insert_turns adds. Error when it is more than `limit` or the keys lie too close in time to hold them.
std::size_t keys_for_turns(const std::vector<TrackKey>& keys, std::size_t limit);

// Adds keys between linear keys about the same axis so that no two are further apart than a quarter turn.
void insert_turns(std::vector<TrackKey>& keys);

// Negates quaternions so that no two neighbours lie on opposite sides: what cubic interpolation needs. Error for keys
// about the same axis that are more than half a turn apart, which a cubic track cannot follow.
void align_signs(std::vector<TrackKey>& keys);

}  // namespace morphcl
