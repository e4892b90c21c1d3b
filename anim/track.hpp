// A track: keys in integer ticks and the rule between them, by the rules of glTF 2.0.
//
// Before the first key and after the last the end values hold; at a key its value is used as it is. Between keys: step
// holds, linear interpolates by (1-u) a + u b in the form exact at both ends (slerp along the shorter arc for rotations),
// cubic is the Hermite spline whose tangents are scaled by the key distance in seconds; rotations are normalised after.
// A track is a pure function of the tick: there is no cursor and no state.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

namespace morphcl {

enum class Interpolation { step, linear, cubic };

class Track {
 public:
  Track() = default;
  // `values` holds, key after key, `width` components (step, linear) or in-tangent, value, out-tangent of `width`
  // components each (cubic). `rotation`: width 4, components x y z w. Tangents are per second.
  // Throws Error(bad_input) when ticks do not increase, the counts do not fit, or a value is not finite. A cubic track
  // needs two keys.
  Track(Interpolation interpolation, int width, bool rotation, std::int64_t ticks_per_second,
        std::vector<std::int64_t> ticks, std::vector<double> values);

  bool empty() const { return ticks_.empty(); }
  int width() const { return width_; }
  Interpolation interpolation() const { return interpolation_; }
  std::int64_t first_tick() const { return ticks_.front(); }
  std::int64_t last_tick() const { return ticks_.back(); }
  void evaluate(std::int64_t tick, double* out) const;  // writes width() values; the track is not empty

 private:
  Interpolation interpolation_ = Interpolation::linear;
  int width_ = 0;
  bool rotation_ = false;
  double seconds_per_tick_ = 0;
  std::vector<std::int64_t> ticks_;
  std::vector<double> values_;
};

}  // namespace morphcl
