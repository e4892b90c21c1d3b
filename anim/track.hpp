// A track: keys in integer ticks and the rule between them, by the rules of glTF 2.0, and springs that follow keys.
//
// Before the first key and after the last the end values hold; at a key its value is used as it is. Between keys: step
// holds, linear interpolates by (1-u) a + u b in the form exact at both ends (slerp along the shorter arc for
// rotations), cubic is the Hermite spline whose tangents are scaled by the key distance in seconds; rotations are
// normalised after. A spring track is the motion of a mass on a spring that follows keys of one of these kinds
// (anim/spring_motion.hpp): it lags, overshoots and goes on after the last key; of a rotation the components of unit
// quaternions on the same side are followed and normalised after. A track is a pure function of the tick: there is no
// cursor and no state. A key is found by binary search.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "anim/spring_motion.hpp"

namespace morphcl {

enum class Interpolation { step, linear, cubic, spring };

// All x with lower <= x <= upper.
struct ValueRange {
  double lower, upper;
};

class Track {
 public:
  Track() = default;
  // `values` holds, key after key, `width` components (step, linear) or in-tangent, value, out-tangent of `width`
  // components each (cubic). `rotation`: width 4, components x y z w, not all 0. Tangents are per second.
  // Throws Error(bad_input) when ticks do not increase, the counts do not fit, or a value is not finite, or for
  // Interpolation::spring, which has more to say. A cubic track needs two keys.
  Track(Interpolation interpolation, int width, bool rotation, std::int64_t ticks_per_second,
        std::vector<std::int64_t> ticks, std::vector<double> values);
  // A spring that follows such keys. Error(bad_input) as above, or for a frequency or damping ratio out of the limits
  // in anim/spring.hpp.
  static Track on_spring(const Spring& spring, Interpolation follows, int width, bool rotation,
                         std::int64_t ticks_per_second, std::vector<std::int64_t> ticks, std::vector<double> values);

  bool operator==(const Track&) const = default;
  bool empty() const { return ticks_.empty(); }
  int width() const { return width_; }
  bool is_rotation() const { return rotation_; }
  Interpolation interpolation() const { return spring_ ? Interpolation::spring : interpolation_; }
  std::int64_t first_tick() const { return ticks_.front(); }
  std::int64_t last_tick() const { return ticks_.back(); }  // of the keys
  // The end of what has to be shown: the last key; a spring's settling_seconds() after it, when it may still swing.
  std::int64_t end_tick() const;
  // Writes width() values; the track is not empty. They are finite, except that a cubic or spring track with values
  // near the largest double may overflow. A rotation that passes exactly through 0 keeps the value of the key before.
  void evaluate(std::int64_t tick, double* out) const;
  // Contains what evaluate() writes for `component` at any tick, but for a few ulps of the largest key; not finite
  // where a cubic or spring track may overflow. For tracks that are no rotations.
  ValueRange range(int component) const;

  // The keys, and the curve through them; of a spring the curve that it follows.
  std::size_t key_count() const { return ticks_.size(); }
  std::int64_t key_tick(std::size_t key) const { return ticks_[key]; }
  const double* key_value(std::size_t key) const;
  std::size_t key_before(std::int64_t tick) const;                    // the last key at or before the tick; else 0
  double seconds_from_key(std::size_t key, std::int64_t tick) const;  // tick >= key_tick(key)
  // From the key to the next one as a polynomial in seconds, linear for linear rotations; constant after the last.
  Cubic curve_from(std::size_t key, int component) const;

 private:
  void interpolate(std::size_t key, std::int64_t tick, double* out) const;
  void hermite(std::size_t key, double u, double seconds, double* out) const;
  void normalize_keys();
  ValueRange key_range(int component) const;
  ValueRange spring_range(int component) const;

  Interpolation interpolation_ = Interpolation::linear;  // of the keys
  int width_ = 0;
  bool rotation_ = false;
  double ticks_per_second_ = 1;
  std::vector<std::int64_t> ticks_;
  std::vector<double> values_;
  std::shared_ptr<const SpringMotion> spring_;  // or null
};

}  // namespace morphcl
