#include "host/scene/shot/rotation_keys.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "host/math/direction.hpp"
#include "morphcl/numerics.hpp"

namespace morphcl {

namespace {

constexpr double quarter_turn = 90, half_turn = 180, max_degrees = 1e9;

KeyComponents quaternion(const AxisAngle& turn) {
  const SinCos half = sin_cos_degrees(turn.degrees / 2);
  const glm::dvec3 v = half.sin * unit(turn.axis);
  return {v.x, v.y, v.z, half.cos};
}

bool about_same_axis(const TrackKey& a, const TrackKey& b) { return a.turn && b.turn && a.turn->axis == b.turn->axis; }

// How many equal pieces the way from a to b is cut into.
double pieces(const TrackKey& a, const TrackKey& b) {
  if (!about_same_axis(a, b)) return 1;
  return std::max(1.0, std::ceil(std::abs(b.turn->degrees - a.turn->degrees) / quarter_turn));
}

void read_axis_angle(const ShotValue& value, TrackKey& key) {
  const ShotTable table = value.table({"axis", "degrees"});
  const ShotValue axis = table.need("axis"), degrees = table.need("degrees");
  const AxisAngle turn{axis.point(), degrees.number()};
  if (turn.axis == glm::dvec3(0.0)) axis.fail("the axis is [0, 0, 0]; it must have a direction");
  if (std::abs(turn.degrees) > max_degrees) degrees.fail(fmt::format("at most {} degrees are possible", max_degrees));
  key.turn = turn;
  key.value = quaternion(turn);
}

void read_quaternion(const ShotValue& value, TrackKey& key) {
  if (!value.is_array() || value.size() != 4)
    value.fail("a rotation is a quaternion [x, y, z, w] or { axis = [x, y, z], degrees = d }");
  double largest = 0, sum = 0;
  for (std::size_t c = 0; c < 4; ++c) {
    key.value[c] = value[c].number();
    largest = std::max(largest, std::abs(key.value[c]));
  }
  if (largest == 0) value.fail("the quaternion is [0, 0, 0, 0]; no rotation is written [0, 0, 0, 1]");
  for (double& component : key.value) {
    component /= largest;
    sum += component * component;
  }
  for (double& component : key.value) component /= std::sqrt(sum);
}

}  // namespace

void read_rotation(const ShotValue& value, TrackKey& key) {
  if (value.is_table())
    read_axis_angle(value, key);
  else
    read_quaternion(value, key);
}

std::size_t keys_for_turns(const std::vector<TrackKey>& keys, std::size_t limit) {
  double added = 0;
  for (std::size_t i = 0; i + 1 < keys.size(); ++i) {
    const double count = pieces(keys[i], keys[i + 1]);
    added += count - 1;
    if (added > static_cast<double>(limit) || count > static_cast<double>(keys[i + 1].tick - keys[i].tick))
      keys[i + 1].source.fail("too many turns since the key before");
  }
  return static_cast<std::size_t>(added);
}

void insert_turns(std::vector<TrackKey>& keys) {
  std::vector<TrackKey> result;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    result.push_back(keys[i]);
    if (i + 1 == keys.size()) break;
    const TrackKey &from = keys[i], &to = keys[i + 1];
    const auto count = static_cast<std::int64_t>(pieces(from, to));
    const std::int64_t ticks = to.tick - from.tick;
    for (std::int64_t piece = 1; piece < count; ++piece) {
      TrackKey key = from;
      const double u = static_cast<double>(piece) / static_cast<double>(count);
      const auto offset = static_cast<std::int64_t>(u * static_cast<double>(ticks));
      key.tick = from.tick + offset;
      // The angle at the whole tick, so that the turn stays even.
      const double at = static_cast<double>(offset) / static_cast<double>(ticks);
      key.turn->degrees += at * (to.turn->degrees - from.turn->degrees);
      key.value = quaternion(*key.turn);
      result.push_back(key);
    }
  }
  keys = std::move(result);
}

void align_signs(std::vector<TrackKey>& keys) {
  for (std::size_t i = 1; i < keys.size(); ++i) {
    const TrackKey& before = keys[i - 1];
    TrackKey& key = keys[i];
    if (about_same_axis(before, key) && std::abs(key.turn->degrees - before.turn->degrees) > half_turn)
      key.source.fail(
          "cubic rotation keys about one axis lie at most 180 degrees apart; add keys between, or use linear");
    double dot = 0;
    for (std::size_t c = 0; c < 4; ++c) dot += before.value[c] * key.value[c];
    if (dot < 0)
      for (double& component : key.value) component = -component;
  }
}

}  // namespace morphcl
