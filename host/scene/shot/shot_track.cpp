#include "host/scene/shot/shot_track.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "host/scene/shot/nearest_name.hpp"
#include "host/scene/shot/rotation_keys.hpp"
#include "morphcl/scene.hpp"
#include "morphcl/track.hpp"

namespace morphcl {

namespace {

std::size_t width(KeyValue kind) {
  if (kind == KeyValue::rotation || kind == KeyValue::color_and_alpha) return 4;
  return kind == KeyValue::point || kind == KeyValue::factor || kind == KeyValue::color ? 3 : 1;
}

KeyComponents components(const glm::dvec3& v) { return {v.x, v.y, v.z, 0}; }

KeyComponents read_tangent(const ShotValue& value, KeyValue kind) {
  if (width(kind) == 1) return {value.number()};
  if (kind == KeyValue::factor) return components(value.factor());
  if (width(kind) == 3) return components(value.vector());
  const char* form = kind == KeyValue::rotation ? "a tangent of a rotation is four numbers: [x, y, z, w]"
                                                : "a tangent of a color with alpha is four numbers";
  if (!value.is_array() || value.size() != 4) value.fail(form);
  return {value[0].number(), value[1].number(), value[2].number(), value[3].number()};
}

KeyComponents read_color_and_alpha(const ShotValue& value) {
  if (!value.is_array() || value.size() != 4)
    value.fail("where one key has alpha all have it: [red, green, blue, alpha]");
  KeyComponents color{};
  for (std::size_t c = 0; c < color.size(); ++c) {
    color[c] = value[c].number();
    if (color[c] < 0 || (c == 3 && color[c] > 1))
      value[c].fail(fmt::format("color holds {}; {} is needed", color[c], c == 3 ? "0 to 1" : "0 or more"));
  }
  return color;
}

void read_value(const ShotValue& value, KeyValue kind, TrackKey& key) {
  switch (kind) {
    case KeyValue::number:
      key.value = {value.number()};
      break;
    case KeyValue::positive:
      key.value = {value.positive()};
      break;
    case KeyValue::field_of_view:
      key.value = {value.field_of_view()};
      break;
    case KeyValue::point:
      key.value = components(value.point());
      break;
    case KeyValue::factor:
      key.value = components(value.factor());
      break;
    case KeyValue::color:
      key.value = components(value.color());
      break;
    case KeyValue::color_and_alpha:
      key.value = read_color_and_alpha(value);
      break;
    case KeyValue::rotation:
      read_rotation(value, key);
      break;
    case KeyValue::flag:
      key.value = {value.is_boolean() ? (value.boolean() ? 1.0 : 0.0) : value.number()};
      break;
  }
}

TrackKey read_key(const ShotValue& source, KeyValue kind, Interpolation interpolation, const TimeBase& time) {
  const bool cubic = interpolation == Interpolation::cubic;
  if (!source.is_array() || (source.size() != 2 && !(cubic && source.size() == 4)))
    source.fail(cubic ? "a cubic key is [frame, value] or [frame, value, in_tangent, out_tangent]"
                      : "a key is [frame, value]");
  TrackKey key{.source = source};
  key.frame = source[0].number();
  if (std::abs(key.frame) > static_cast<double>(max_frame_number))
    source[0].fail(fmt::format("frame {}; frames reach from {} to {}", key.frame, -max_frame_number, max_frame_number));
  key.tick = placed_at(source[0], [&] { return time.frames_to_ticks(key.frame); });
  read_value(source[1], kind, key);
  key.has_tangents = source.size() == 4;
  if (key.has_tangents) {
    key.in_tangent = read_tangent(source[2], kind);
    key.out_tangent = read_tangent(source[3], kind);
  }
  return key;
}

std::vector<TrackKey> read_track_keys(const ShotValue& list, KeyValue kind, Interpolation interpolation,
                                      const TimeBase& time) {
  std::vector<TrackKey> keys;
  keys.reserve(list.size());
  for (std::size_t i = 0; i < list.size(); ++i) {
    keys.push_back(read_key(list[i], kind, interpolation, time));
    if (i == 0) continue;
    if (keys[i].tick <= keys[i - 1].tick)
      list[i].fail(fmt::format("frame {} does not come after frame {}; keys must be in order, one a frame",
                               keys[i].frame, keys[i - 1].frame));
    if (keys[i].has_tangents != keys[0].has_tangents)
      list[i].fail("either all keys of a track have tangents or none has");
  }
  if (keys.empty()) list.fail("keys is empty; a track needs at least one key");
  if (interpolation == Interpolation::cubic && keys.size() < 2) list.fail("a cubic track needs at least two keys");
  return keys;
}

void set_default_tangents(std::vector<TrackKey>& keys, std::size_t components) {
  std::vector<double> frames, values(keys.size());
  frames.reserve(keys.size());
  for (const TrackKey& key : keys) frames.push_back(key.frame);
  for (std::size_t c = 0; c < components; ++c) {
    for (std::size_t i = 0; i < keys.size(); ++i) values[i] = keys[i].value[c];
    const std::vector<double> tangents = default_tangents(frames, values);
    for (std::size_t i = 0; i < keys.size(); ++i) keys[i].in_tangent[c] = keys[i].out_tangent[c] = tangents[i];
  }
}

Interpolation key_rule(const ShotValue& given, const std::vector<std::string_view>& known) {
  const std::string& name = given.text();
  if (std::find(known.begin(), known.end(), name) == known.end())
    given.fail(fmt::format("unknown {} \"{}\"{}", given.name(), name, suggestion(name, known)));
  if (name == "spring") return Interpolation::spring;
  return name == "step" ? Interpolation::step : name == "linear" ? Interpolation::linear : Interpolation::cubic;
}

double read_within(const ShotValue& value, double min, double max, const char* unit) {
  const double number = value.number();
  if (!(number >= min && number <= max))
    value.fail(fmt::format("{} is {}; {} to {}{} is possible", value.name(), number, min, max, unit));
  return number;
}

Motion read_motion(const ShotTable& track, KeyValue kind) {
  const auto given = track.find("interpolation");
  const Interpolation interpolation = given                    ? key_rule(*given, {"step", "linear", "cubic", "spring"})
                                      : kind == KeyValue::flag ? Interpolation::step
                                                               : Interpolation::linear;
  if (kind == KeyValue::flag && interpolation != Interpolation::step)
    given->fail("true and false have nothing between them; use \"step\"");
  if (interpolation != Interpolation::spring) {
    for (const char* key : {"frequency", "damping_ratio", "follows"})
      if (const auto value = track.find(key)) value->fail(fmt::format("only a spring has a {}", key));
    return {interpolation, std::nullopt};
  }
  const double frequency =
      read_within(track.need("frequency"), min_spring_frequency_hz, max_spring_frequency_hz, " Hz");
  const auto damping = track.find("damping_ratio");
  const auto follows = track.find("follows");
  return {follows ? key_rule(*follows, {"step", "linear", "cubic"}) : Interpolation::linear,
          spring_of_frequency(frequency, damping ? read_within(*damping, 0, max_damping_ratio, "") : 0.5)};
}

}  // namespace

void TrackReader::charge_keys(const ShotValue& at, std::size_t count) {
  if (count > keys_left_) at.fail("the shot has too many keys; 2,000,000 are possible in all");
  keys_left_ -= count;
}

Track TrackReader::read(const ShotTable& track, KeyValue kind, double factor) {
  const Motion motion = read_motion(track, kind);
  return read_list(track.need("keys"), motion, kind, factor);
}

bool TrackReader::are_keys(const ShotValue& value) {
  return value.has("keys") || (value.is_array() && value.size() > 0 && value[0].is_array());
}

Track TrackReader::read_keys(const ShotValue& value, KeyValue kind) {
  if (value.is_array()) return read_list(value, {}, kind, 1);
  return read(value.table({"interpolation", "frequency", "damping_ratio", "follows", "keys"}), kind);
}

Track TrackReader::read_list(const ShotValue& list, const Motion& motion, KeyValue kind, double factor) {
  const Interpolation interpolation = motion.keys;
  const bool cubic = interpolation == Interpolation::cubic, rotation = kind == KeyValue::rotation;
  charge_keys(list, list.size());
  std::vector<TrackKey> keys = read_track_keys(list, kind, interpolation, time_);
  if (rotation && interpolation == Interpolation::linear) {
    charge_keys(list, keys_for_turns(keys, keys_left_));
    insert_turns(keys);
  }
  if (cubic && !keys[0].has_tangents) {
    if (rotation) align_signs(keys);
    set_default_tangents(keys, width(kind));
  }

  std::vector<std::int64_t> ticks;
  std::vector<double> values;
  ticks.reserve(keys.size());
  values.reserve(keys.size() * width(kind) * (cubic ? 3 : 1));
  const double tangent_factor =
      factor * static_cast<double>(time_.fps_numerator) / static_cast<double>(time_.fps_denominator);
  for (const TrackKey& key : keys) {
    ticks.push_back(key.tick);
    for (std::size_t c = 0; c < width(kind) && cubic; ++c) values.push_back(tangent_factor * key.in_tangent[c]);
    for (std::size_t c = 0; c < width(kind); ++c) values.push_back(factor * key.value[c]);
    for (std::size_t c = 0; c < width(kind) && cubic; ++c) values.push_back(tangent_factor * key.out_tangent[c]);
  }
  return placed_at(list, [&] {
    const int components = static_cast<int>(width(kind));
    return motion.spring ? Track({interpolation, components, rotation, time_.ticks_per_second(), std::move(ticks),
                                  std::move(values)})
                               .on_spring(*motion.spring)
                         : Track({interpolation, components, rotation, time_.ticks_per_second(), std::move(ticks),
                                  std::move(values)});
  });
}

}  // namespace morphcl
