#include "morphcl/track.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>

#include "anim/spring_motion.hpp"
#include "morphcl/error.hpp"
#include "morphcl/numerics.hpp"
#include "morphcl/rotation.hpp"

namespace morphcl {

namespace {

[[noreturn]] void refuse(const std::string& message) { throw Error(ErrorKind::bad_input, "", message); }

void require(bool holds, const char* what, double value, double min, double max) {
  if (!holds) refuse(fmt::format("a spring's {} is {}; it must be {} to {}", what, value, min, max));
}

std::size_t values_per_key(Interpolation interpolation, int width) {
  return static_cast<std::size_t>(width) * (interpolation == Interpolation::cubic ? 3 : 1);
}

// b - a for a < b, also where the difference does not fit into 63 bits.
double distance(std::int64_t a, std::int64_t b) {
  return static_cast<double>(static_cast<std::uint64_t>(b) - static_cast<std::uint64_t>(a));
}

glm::dquat load(const double* xyzw) { return {xyzw[3], xyzw[0], xyzw[1], xyzw[2]}; }

void store(const glm::dquat& q, double* xyzw) {
  xyzw[0] = q.x;
  xyzw[1] = q.y;
  xyzw[2] = q.z;
  xyzw[3] = q.w;
}

bool is_zero(const double* xyzw) {
  return std::all_of(xyzw, xyzw + 4, [](double c) { return c == 0; });
}

void normalize_or(const double* fallback, double* xyzw) {
  if (is_zero(xyzw))
    std::copy_n(fallback, 4, xyzw);
  else
    store(normalized(load(xyzw)), xyzw);
}

void append(double value, std::vector<double>& values) { values.push_back(value); }
void append(const glm::dvec3& value, std::vector<double>& values) {
  values.insert(values.end(), {value.x, value.y, value.z});
}
void append(const glm::dquat& value, std::vector<double>& values) {
  values.insert(values.end(), {value.x, value.y, value.z, value.w});
}

template <class Key>
TickKeys tick_keys(Interpolation interpolation, const TimeBase& time, const std::vector<Key>& keys) {
  TickKeys made;
  made.interpolation = interpolation;
  made.rotation = std::is_same_v<Key, RotationKey>;
  made.ticks_per_second = time.ticks_per_second();
  for (const Key& key : keys) {
    made.ticks.push_back(time.frames_to_ticks(key.frame));
    append(key.value, made.values);
  }
  made.width = keys.empty() ? 1 : static_cast<int>(made.values.size() / keys.size());
  return made;
}

// In front of each value its tangent, and the same behind it. Keys that a cubic track refuses are left to it.
TickKeys with_tangents(TickKeys keys) {
  const std::size_t count = keys.ticks.size(), width = static_cast<std::size_t>(keys.width);
  if (count < 2 || std::adjacent_find(keys.ticks.begin(), keys.ticks.end(), std::greater_equal()) != keys.ticks.end()) {
    keys.values.resize(3 * count * width);
    return keys;
  }
  std::vector<double> seconds, component(count), values(3 * count * width);
  for (const std::int64_t tick : keys.ticks)
    seconds.push_back(distance(keys.ticks.front(), tick) / static_cast<double>(keys.ticks_per_second));
  for (std::size_t c = 0; c < width; ++c) {
    for (std::size_t key = 0; key < count; ++key) component[key] = keys.values[key * width + c];
    const std::vector<double> tangents = default_tangents(seconds, component);
    for (std::size_t key = 0; key < count; ++key) {
      double* const out = &values[3 * key * width + c];
      out[0] = out[2 * width] = tangents[key];
      out[width] = component[key];
    }
  }
  keys.values = std::move(values);
  return keys;
}

}  // namespace

Track::Track(TickKeys keys)
    : interpolation_(keys.interpolation),
      width_(keys.width),
      rotation_(keys.rotation),
      ticks_per_second_(static_cast<double>(keys.ticks_per_second)),
      ticks_(std::move(keys.ticks)),
      values_(std::move(keys.values)) {
  const auto [interpolation, width, rotation] = std::tuple(interpolation_, width_, rotation_);
  if (interpolation == Interpolation::spring) refuse("a spring track needs a spring; use Track::on_spring");
  if (width < 1) refuse(fmt::format("a track has {} components a key; it needs at least 1", width));
  if (rotation && width != 4)
    refuse(fmt::format("a rotation track has {} components a key; it needs 4: x y z w", width));
  if (keys.ticks_per_second < 1)
    refuse(fmt::format("a track has {} ticks a second; it needs at least 1", keys.ticks_per_second));
  const std::size_t min_keys = interpolation == Interpolation::cubic ? 2 : 1;
  if (ticks_.size() < min_keys)
    refuse(fmt::format("a track has {} keys; this interpolation needs at least {}", ticks_.size(), min_keys));
  const std::size_t per_key = values_per_key(interpolation, width);
  if (values_.size() / per_key != ticks_.size() || values_.size() % per_key != 0)
    refuse(fmt::format("a track of {} keys has {} values; it needs {} a key", ticks_.size(), values_.size(), per_key));
  for (std::size_t key = 1; key < ticks_.size(); ++key)
    if (ticks_[key] <= ticks_[key - 1])
      refuse(fmt::format("key {} of a track is not later than key {}; times must increase", key, key - 1));
  for (std::size_t i = 0; i < values_.size(); ++i)
    if (!std::isfinite(values_[i]))
      refuse(fmt::format("key {} of a track holds a value that is NaN or infinite; it must be finite", i / per_key));
  for (std::size_t key = 0; rotation && key < ticks_.size(); ++key)
    if (is_zero(key_value(key)))
      refuse(fmt::format("key {} of a rotation track is 0 0 0 0; a rotation is a quaternion of length 1", key));
}

Track Track::step(const TimeBase& time, const std::vector<NumberKey>& keys) {
  return Track(tick_keys(Interpolation::step, time, keys));
}
Track Track::step(const TimeBase& time, const std::vector<VectorKey>& keys) {
  return Track(tick_keys(Interpolation::step, time, keys));
}
Track Track::step(const TimeBase& time, const std::vector<RotationKey>& keys) {
  return Track(tick_keys(Interpolation::step, time, keys));
}
Track Track::linear(const TimeBase& time, const std::vector<NumberKey>& keys) {
  return Track(tick_keys(Interpolation::linear, time, keys));
}
Track Track::linear(const TimeBase& time, const std::vector<VectorKey>& keys) {
  return Track(tick_keys(Interpolation::linear, time, keys));
}
Track Track::linear(const TimeBase& time, const std::vector<RotationKey>& keys) {
  return Track(tick_keys(Interpolation::linear, time, keys));
}
Track Track::cubic(const TimeBase& time, const std::vector<NumberKey>& keys) {
  return Track(with_tangents(tick_keys(Interpolation::cubic, time, keys)));
}
Track Track::cubic(const TimeBase& time, const std::vector<VectorKey>& keys) {
  return Track(with_tangents(tick_keys(Interpolation::cubic, time, keys)));
}

bool Track::operator==(const Track& other) const {
  return interpolation_ == other.interpolation_ && width_ == other.width_ && rotation_ == other.rotation_ &&
         ticks_per_second_ == other.ticks_per_second_ && ticks_ == other.ticks_ && values_ == other.values_ &&
         spring() == other.spring();
}

std::optional<Spring> Track::spring() const { return spring_ ? std::optional(spring_->spring()) : std::nullopt; }

Track Track::on_spring(const Spring& spring) const {
  if (empty()) refuse("a spring follows keys; this track has none");
  const Spring slowest = spring_of_frequency(min_spring_frequency_hz, 0),
               fastest = spring_of_frequency(max_spring_frequency_hz, 0);
  const double omega = spring.angular_frequency, zeta = spring.damping_ratio;
  require(omega >= slowest.angular_frequency && omega <= fastest.angular_frequency, "angular frequency", omega,
          slowest.angular_frequency, fastest.angular_frequency);
  require(zeta >= 0 && zeta <= max_damping_ratio, "damping ratio", zeta, 0, max_damping_ratio);
  Track track = *this;
  if (rotation_) track.normalize_keys();
  track.spring_ = std::make_shared<const SpringMotion>(spring, track);
  return track;
}

// Unit length and no two neighbours on opposite sides, tangents with them: what can be followed component by component.
void Track::normalize_keys() {
  const std::size_t per_key = values_per_key(interpolation_, width_);
  const std::size_t offset = interpolation_ == Interpolation::cubic ? 4 : 0;
  glm::dquat before(1, 0, 0, 0);
  for (std::size_t key = 0; key < ticks_.size(); ++key) {
    double* const values = values_.data() + key * per_key;
    const glm::dquat given = load(values + offset);
    glm::dquat unit = normalized(given);
    const bool turned = key > 0 && glm::dot(before, unit) < 0;
    if (turned) unit = -unit;
    // Tangents are scaled as the key is.
    const double* const largest = std::max_element(values + offset, values + offset + 4,
                                                   [](double a, double b) { return std::abs(a) < std::abs(b); });
    double components[4];
    store(unit, components);
    const double factor = components[largest - (values + offset)] / *largest;
    for (std::size_t i = 0; i < per_key; ++i) values[i] *= factor;
    std::copy_n(components, 4, values + offset);
    before = unit;
  }
}

const double* Track::key_value(std::size_t key) const {
  const bool cubic = interpolation_ == Interpolation::cubic;
  return values_.data() + key * values_per_key(interpolation_, width_) + (cubic ? width_ : 0);
}

std::size_t Track::key_before(std::int64_t tick) const {
  const auto next = std::upper_bound(ticks_.begin(), ticks_.end(), tick);
  return next == ticks_.begin() ? 0 : static_cast<std::size_t>(next - ticks_.begin()) - 1;
}

double Track::seconds_from_key(std::size_t key, std::int64_t tick) const {
  return distance(ticks_[key], tick) / ticks_per_second_;
}

Cubic Track::curve_from(std::size_t key, int component) const {
  const double* a = key_value(key) + component;
  if (key + 1 == ticks_.size() || interpolation_ == Interpolation::step) return {*a, 0, 0, 0};
  const double* b = key_value(key + 1) + component;
  const double seconds = seconds_from_key(key, ticks_[key + 1]), slope = (*b - *a) / seconds;
  if (interpolation_ == Interpolation::linear) return {*a, slope, 0, 0};
  const double out_tangent = a[width_], in_tangent = b[-width_];
  return {*a, out_tangent, ((slope - out_tangent) + (slope - out_tangent) + (slope - in_tangent)) / seconds,
          ((out_tangent - slope) + (in_tangent - slope)) / seconds / seconds};
}

std::int64_t Track::end_tick() const {
  if (!spring_) return last_tick();
  constexpr double max_ticks = 0x1p62;
  const double settling = std::ceil(settling_seconds(spring_->spring()) * ticks_per_second_);
  return last_tick() +
         static_cast<std::int64_t>(std::min(settling, max_ticks - std::abs(static_cast<double>(last_tick()))));
}

void Track::evaluate(std::int64_t tick, double* out) const {
  if (spring_) {
    spring_->evaluate(*this, tick, out);
    if (rotation_) normalize_or(key_value(key_before(tick)), out);
    return;
  }
  const std::size_t key = key_before(tick);
  const bool holds = tick <= ticks_[key] || key + 1 == ticks_.size() || interpolation_ == Interpolation::step;
  if (holds)
    std::copy_n(key_value(key), width_, out);
  else
    interpolate(key, tick, out);
}

void Track::interpolate(std::size_t key, std::int64_t tick, double* out) const {
  const double ticks = distance(ticks_[key], ticks_[key + 1]);
  const double u = distance(ticks_[key], tick) / ticks;
  const double *a = key_value(key), *b = key_value(key + 1);
  if (interpolation_ == Interpolation::cubic)
    hermite(key, u, ticks / ticks_per_second_, out);
  else if (rotation_)
    store(slerp(load(a), load(b), u), out);
  else
    for (int i = 0; i < width_; ++i) out[i] = lerp(a[i], b[i], u);
}

void Track::hermite(std::size_t key, double u, double seconds, double* out) const {
  const double *a = key_value(key), *b = key_value(key + 1);
  const double *out_tangent = a + width_, *in_tangent = b - width_;
  const double v = 1 - u;
  // The four cubic Hermite weights as products: no cancellation, weights of a and b add up to 1.
  const double to_b = u * u * (1 + 2 * v);
  const double out_weight = u * v * v * seconds, in_weight = -u * u * v * seconds;
  for (int i = 0; i < width_; ++i)
    out[i] = lerp(a[i], b[i], to_b) + std::fma(out_weight, out_tangent[i], in_weight * in_tangent[i]);
  if (rotation_) normalize_or(a, out);
}

ValueRange Track::range(int component) const { return spring_ ? spring_range(component) : key_range(component); }

ValueRange Track::key_range(int component) const {
  ValueRange range{key_value(0)[component], key_value(0)[component]};
  const auto include = [&range](double value) { range = {std::min(range.lower, value), std::max(range.upper, value)}; };
  for (std::size_t key = 1; key < ticks_.size(); ++key) include(key_value(key)[component]);
  if (interpolation_ != Interpolation::cubic) return range;
  // Between two keys a cubic leaves their interval by at most its tangents times u (1-u)^2 and u^2 (1-u), each at most
  // 4/27 of the distance in seconds.
  double reach = 0;
  for (std::size_t key = 0; key + 1 < ticks_.size(); ++key) {
    const double seconds = distance(ticks_[key], ticks_[key + 1]) / ticks_per_second_;
    const double out_tangent = (key_value(key) + width_)[component];
    const double in_tangent = (key_value(key + 1) - width_)[component];
    reach = std::max(reach, 4.0 / 27.0 * seconds * (std::abs(out_tangent) + std::abs(in_tangent)));
  }
  return {range.lower - reach, range.upper + reach};
}

// Two bounds hold: the mass leaves the range of its target by at most the factor largest_overshoot(), and since no
// free motion from rest ever exceeds its start, it is never further from the target than the target has come in all.
ValueRange Track::spring_range(int component) const {
  // The rounding of a step changes the energy of a state by a few u, in 2,000,000 keys by less than this part.
  constexpr double rounding = 1e-8;
  const ValueRange followed = key_range(component);
  double travel = 0;
  for (std::size_t key = 0; key + 1 < ticks_.size(); ++key) {
    const double *a = key_value(key) + component, *b = key_value(key + 1) + component;
    if (interpolation_ != Interpolation::cubic) {
      travel += std::abs(*b - *a);
      continue;
    }
    // A cubic is no longer than its control polygon.
    const double third = seconds_from_key(key, ticks_[key + 1]) / 3;
    const double first = a[width_] * third, last = b[-width_] * third;
    travel += std::abs(first) + std::abs(last) + std::abs((*b - *a) - (first + last));
  }
  const double half = 0.5 * followed.upper - 0.5 * followed.lower, middle = 0.5 * followed.lower + 0.5 * followed.upper;
  const double overshoot = largest_overshoot(spring_->spring().damping_ratio);
  const double reach = half == 0 ? 0 : std::min(half * overshoot, half + travel) * (1 + rounding);
  return {middle - reach, middle + reach};
}

}  // namespace morphcl
