#include "host/scene/shot/shot_light.hpp"

#include <fmt/format.h>

#include "host/scene/shot/color_hint.hpp"
#include "host/scene/shot/nearest_name.hpp"

namespace morphcl {

namespace {

void refuse_zero(const ShotValue& value, const glm::dvec3& direction) {
  if (direction == glm::dvec3(0.0))
    value.fail("direction is [0, 0, 0]; it must point from the scene towards the light");
}

void read_light_track(const ShotValue& value, double intensity, TrackReader& tracks, Light& light) {
  const ShotTable table = TrackReader::table(value);
  const ShotValue target = TrackReader::target(table);
  const std::string& name = target.text();
  const std::string_view vector_name = light.kind == LightKind::point ? "position" : "direction";
  if (name != vector_name && name != "color")
    target.fail(fmt::format("a light has no value \"{}\" to move{}", name, suggestion(name, {vector_name, "color"})));
  Track& track = name == "color" ? light.color_track : light.vector_track;
  if (!track.empty()) target.fail(fmt::format("{} is driven twice", name));
  track = name == "color" ? tracks.read(table, KeyValue::color, intensity) : tracks.read(table, KeyValue::vector);
}

}  // namespace

Light read_light(const ShotValue& value, std::size_t index, TrackReader& tracks, ParentLinks& parents) {
  const ShotTable table = value.table({"direction", "position", "color", "intensity", "falloff", "parent", "track"});
  if (const auto parent = table.find("parent")) parents.hang_light(*parent, index);
  const auto direction = table.find("direction"), position = table.find("position");
  if (direction.has_value() == position.has_value()) value.fail("a light needs either a direction or a position");

  Light light;
  light.kind = position ? LightKind::point : LightKind::directional;
  light.vector = position ? position->vector() : direction->vector();
  if (direction) refuse_zero(*direction, light.vector);

  double intensity = 1;
  if (const auto given = table.find("intensity")) {
    intensity = given->number();
    if (intensity < 0) given->fail(fmt::format("intensity is {}; 0 or more is needed", intensity));
  }
  if (const auto color = table.find("color")) {
    light.color = color->color();
    if (direction) refuse_codes(*color);  // one with a position may be that bright
  }
  light.color *= intensity;
  if (const auto falloff = table.find("falloff")) {
    light.falloff = falloff->boolean();
    if (direction && light.falloff) falloff->fail("only a light with a position falls off with distance");
  }
  table.for_each("track", [&](const ShotValue& track) { read_light_track(track, intensity, tracks, light); });
  return light;
}

}  // namespace morphcl
