// A track: keys in integer ticks and the rule between them, by the rules of glTF 2.0.
//
// Before the first key and after the last the end values hold; at a key its value is used as it is. Between keys: step
// holds, linear interpolates by (1-u) a + u b in the form exact at both ends (slerp along the shorter arc for
// rotations), cubic is the Hermite spline whose tangents are scaled by the key distance in seconds; rotations are
// normalised after. A track is a pure function of the tick: there is no cursor and no state. A key is found by binary
// search.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace morphcl {

enum class Interpolation { step, linear, cubic };

// All x with lower <= x <= upper.
struct ValueRange {
  double lower, upper;
};

class Track {
 public:
  Track() = default;
  // `values` holds, key after key, `width` components (step, linear) or in-tangent, value, out-tangent of `width`
  // components each (cubic). `rotation`: width 4, components x y z w, not all 0. Tangents are per second.
  // Throws Error(bad_input) when ticks do not increase, the counts do not fit, or a value is not finite. A cubic track
  // needs two keys.
  Track(Interpolation interpolation, int width, bool rotation, std::int64_t ticks_per_second,
        std::vector<std::int64_t> ticks, std::vector<double> values);

  bool empty() const { return ticks_.empty(); }
  int width() const { return width_; }
  bool is_rotation() const { return rotation_; }
  Interpolation interpolation() const { return interpolation_; }
  std::int64_t first_tick() const { return ticks_.front(); }
  std::int64_t last_tick() const { return ticks_.back(); }
  // Writes width() values; the track is not empty. They are finite, except that a cubic track with values near the
  // largest double may overflow. A cubic rotation that passes exactly through 0 keeps the value of the key before.
  void evaluate(std::int64_t tick, double* out) const;
  // Contains what evaluate() writes for `component` at any tick, but for a few ulps of the largest key; not finite
  // where a cubic track may overflow. For tracks that are no rotations.
  ValueRange range(int component) const;

 private:
  const double* key_value(std::size_t key) const;
  void interpolate(std::size_t key, std::int64_t tick, double* out) const;
  void hermite(std::size_t key, double u, double seconds, double* out) const;

  Interpolation interpolation_ = Interpolation::linear;
  int width_ = 0;
  bool rotation_ = false;
  double ticks_per_second_ = 1;
  std::vector<std::int64_t> ticks_;
  std::vector<double> values_;
};

}  // namespace morphcl
