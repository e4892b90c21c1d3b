// The [[object.track]], [[camera.track]] and [[light.track]] tables of a shot file.
#pragma once

#include <cstddef>
#include <optional>

#include "host/scene/shot/shot_value.hpp"
#include "morphcl/track.hpp"

namespace morphcl {

// What the value of a key looks like.
enum class KeyValue {
  number,
  positive,         // a number > 0
  field_of_view,    // degrees, more than 0 and less than 180
  point,            // [x, y, z], or other coordinates: what is between keys is on the way straight from one to the next
  factor,           // [x, y, z], or one number for all three
  color,            // [r, g, b], each >= 0
  color_and_alpha,  // [r, g, b, alpha], alpha from 0 to 1
  rotation,         // a quaternion [x, y, z, w], or { axis = [x, y, z], degrees = d }
  flag,             // true or false; always a step track, of width 1
};

// How the values between keys are found, and the spring that follows them, where there is one.
struct Motion {
  Interpolation keys = Interpolation::linear;
  std::optional<Spring> spring = std::nullopt;
};

// Reads tracks, and counts the keys of the whole shot.
class TrackReader {
 public:
  explicit TrackReader(const TimeBase& time) : time_(time) {}

  // The table of a track, its keys checked, and the value of its key `target`.
  static ShotTable table(const ShotValue& track) {
    return track.table({"target", "interpolation", "frequency", "damping_ratio", "follows", "keys"});
  }
  static ShotValue target(const ShotTable& track) { return track.need("target"); }

  // Values and tangents are multiplied by `factor`.
  //
  // Keys are [frame, value]; cubic ones are [frame, value, in_tangent, out_tangent] with tangents as change per frame,
  // or all of them [frame, value]: then the tangents are default_tangents(): those of Catmull and Rom where keys are
  // evenly spaced, limited ones elsewhere. A spring follows keys of the kind that `follows` names.
  // Rotations: see rotation_keys.hpp.
  Track read(const ShotTable& track, KeyValue kind, double factor = 1);

  // Keys in the place of a constant: a list of them, which are linear, or a table that says what a track says but for
  // its target.
  static bool are_keys(const ShotValue& value);
  Track read_keys(const ShotValue& value, KeyValue kind);

 private:
  Track read_list(const ShotValue& list, const Motion& motion, KeyValue kind, double factor);
  void charge_keys(const ShotValue& at, std::size_t count);

  TimeBase time_;
  std::size_t keys_left_ = 2'000'000;
};

}  // namespace morphcl
