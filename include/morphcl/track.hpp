// What moves: time in ticks, keys and the rule between them, springs that follow keys.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#pragma GCC visibility push(default)
namespace morphcl {

// ---- time base ------------------------------------------------------------------------------------------------------
//
// Integer time. One second is fps_numerator * 1,000,000 ticks, so frame k starts at exactly k * fps_denominator *
// 1,000,000 ticks, and a key given in seconds is rounded to the nearest tick, 1/(fps_numerator * 1e6) s.

struct TimeBase {
  std::int64_t fps_numerator = 25;   // > 0, at most 1,000,000
  std::int64_t fps_denominator = 1;  // > 0, at most 1,000,000

  std::int64_t ticks_per_second() const { return fps_numerator * 1'000'000; }
  std::int64_t ticks_per_frame() const { return fps_denominator * 1'000'000; }
  std::int64_t frame_ticks(std::int64_t frame) const { return frame * ticks_per_frame(); }  // |frame| <= 1,000,000
  // Nearest tick, ties to even; throws Error(bad_input) when not finite or beyond 2^62 ticks.
  std::int64_t seconds_to_ticks(double seconds) const;
  // The same for a time stored in 32 bits, as glTF does. Where `seconds` is the float nearest to a frame's time, that
  // frame is meant: a step at 1.04f must not come a frame late because 1.04f is a little more than 26/25. Keeps
  // different times apart.
  std::int64_t float_seconds_to_ticks(float seconds) const;
  std::int64_t frames_to_ticks(double frame) const;  // as seconds_to_ticks, of a frame number, fractions allowed
};

// ---- spring ---------------------------------------------------------------------------------------------------------

// A damped spring that follows a target, exactly:  x'' + 2 zeta omega x' + omega^2 (x - target) = 0.
struct Spring {
  double angular_frequency = 0;  // omega, radians per second; > 0
  double damping_ratio = 0;      // zeta >= 0: 1 is critical, below it rings

  bool operator==(const Spring&) const = default;
};

// `frequency_hz`: cycles per second of the spring without damping.
Spring spring_of_frequency(double frequency_hz, double damping_ratio);

// Limits that keep every intermediate result finite: what tracks and shot files may ask for.
constexpr double min_spring_frequency_hz = 1e-6, max_spring_frequency_hz = 1e7, max_damping_ratio = 1e6;

// ---- track ----------------------------------------------------------------------------------------------------------
//
// Keys in integer ticks and the rule between them, by the rules of glTF 2.0, and springs that follow keys.
//
// Before the first key and after the last the end values hold; at a key its value is used as it is. Between keys: step
// holds, linear interpolates by (1-u) a + u b in the form exact at both ends (slerp along the shorter arc for
// rotations), cubic is the Hermite spline whose tangents are scaled by the key distance in seconds; rotations are
// normalised after. A spring track is the motion of a mass on a spring that follows keys of one of these kinds. Up to
// the first key it rests at that key's value; then it lags, overshoots and goes on after the last key; of a rotation
// the components of unit quaternions on the same side are followed and normalised after. A track is a pure function of
// the tick: there is no cursor and no state. A key is found by binary search. Rotations are x y z w.

enum class Interpolation { step, linear, cubic, spring };

// All x with lower <= x <= upper.
struct ValueRange {
  double lower, upper;
};

// Keys at frame numbers, fractions allowed, which must increase.
struct NumberKey {
  double frame;
  double value;
};
struct VectorKey {
  double frame;
  glm::dvec3 value;
};
struct RotationKey {
  double frame;
  glm::dquat value;  // not of length 0
};

// Keys of any width, in ticks: what importers have.
struct TickKeys {
  Interpolation interpolation = Interpolation::linear;
  int width = 1;          // components of a value
  bool rotation = false;  // width 4, components x y z w, not all 0
  std::int64_t ticks_per_second = 0;
  std::vector<std::int64_t> ticks;  // must increase
  // Key after key `width` components (step, linear), or in-tangent, value, out-tangent of `width` components each
  // (cubic). Tangents are per second.
  std::vector<double> values;
};

// From one key to the next: c[0] + c[1] t + c[2] t^2 + c[3] t^3, t in seconds from the first.
using Cubic = std::array<double, 4>;

class SpringMotion;

class Track {
 public:
  Track() = default;  // empty: where a timeline may have a track, it has none

  // Track::linear(time, {{0, 0.0}, {100, 1.0}}): 0 at frame 0, 1 at frame 100. `time` is the timeline's: tracks
  // keep its ticks, and in a timeline of another rate they run too fast or too slow, which is not tested.
  // Error(bad_input): no key, frames that do not increase, a number that is not finite.
  static Track step(const TimeBase& time, const std::vector<NumberKey>& keys);
  static Track step(const TimeBase& time, const std::vector<VectorKey>& keys);
  static Track step(const TimeBase& time, const std::vector<RotationKey>& keys);
  static Track linear(const TimeBase& time, const std::vector<NumberKey>& keys);
  static Track linear(const TimeBase& time, const std::vector<VectorKey>& keys);
  static Track linear(const TimeBase& time, const std::vector<RotationKey>& keys);
  // Through the keys with default_tangents(); at least two keys. (Cubic rotations have tangents of their own:
  // TickKeys.)
  static Track cubic(const TimeBase& time, const std::vector<NumberKey>& keys);
  static Track cubic(const TimeBase& time, const std::vector<VectorKey>& keys);

  // Error(bad_input) when ticks do not increase, the counts do not fit, or a value is not finite, or for
  // Interpolation::spring: on_spring() makes those. A cubic track needs two keys.
  explicit Track(TickKeys keys);

  // The motion of a spring that follows these keys. Error(bad_input) for a frequency or damping ratio out of the limits
  // above, and where there are no keys. A spring that the track already has is replaced.
  Track on_spring(const Spring& spring) const;

  bool operator==(const Track& other) const;  // the same motion: equal keys, rule and spring
  bool empty() const { return ticks_.empty(); }
  int width() const { return width_; }
  bool is_rotation() const { return rotation_; }
  Interpolation interpolation() const { return spring_ ? Interpolation::spring : interpolation_; }
  std::int64_t first_tick() const { return ticks_.front(); }  // this and what follows: of a track that is not empty
  std::int64_t last_tick() const { return ticks_.back(); }    // of the keys
  // The last key's tick; of a spring track the tick when it has settled to about 1/1000, at most 10 s after that key.
  std::int64_t end_tick() const;
  // Writes width() values. They are finite, except that a cubic or spring track with values
  // near the largest double may overflow. A rotation that passes exactly through 0 keeps the value of the key before.
  void evaluate(std::int64_t tick, double* out) const;
  // Contains what evaluate() writes for `component` at any tick, but for a few ulps of the largest key; not finite
  // where a cubic or spring track may overflow. For tracks that are no rotations.
  ValueRange range(int component) const;

  // The keys as they are stored (TickKeys), and the spring that follows them.
  std::span<const std::int64_t> ticks() const { return ticks_; }
  std::span<const double> values() const { return values_; }
  std::optional<Spring> spring() const;

  // The keys, and the curve through them; of a spring the curve that it follows.
  std::size_t key_count() const { return ticks_.size(); }
  std::int64_t key_tick(std::size_t key) const { return ticks_[key]; }
  const double* key_value(std::size_t key) const;                     // its width() values, without tangents
  std::size_t key_before(std::int64_t tick) const;                    // the last key at or before the tick; else 0
  double seconds_from_key(std::size_t key, std::int64_t tick) const;  // tick >= key_tick(key)
  // From the key to the next one as a polynomial in seconds from the key; of linear rotations the chord, not the arc;
  // constant for step, and after the last key.
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

// ---- tangents -------------------------------------------------------------------------------------------------------
//
// For cubic keys that have none of their own.
//
// Where a key's neighbours are equally far away, the tangent is the slope between them (Catmull and Rom). Elsewhere it
// is that of the parabola through the three keys (Bessel), limited as Fritsch and Carlson (1980) do: 0 where the values
// turn round, else at most three times the smaller of the two slopes. So a pair of keys that nearly coincide does not
// throw the curve out of their neighbourhood, as its steep slope would, and rising values give a rising curve. At the
// ends the tangent is the slope to the only neighbour.

// One tangent a key, in value per unit of time. `times` increase; as many values as times, at least 2; not tested.
std::vector<double> default_tangents(std::span<const double> times, std::span<const double> values);

// The limited form at every key, evenly spaced or not: between two keys the curve never leaves the interval of their
// values, if the values of all keys rise or all fall.
std::vector<double> monotone_tangents(std::span<const double> times, std::span<const double> values);

}  // namespace morphcl
#pragma GCC visibility pop
