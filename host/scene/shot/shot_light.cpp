#include "host/scene/shot/shot_light.hpp"

#include <fmt/format.h>

#include <optional>

#include "host/scene/shot/color_hint.hpp"
#include "host/scene/shot/nearest_name.hpp"

namespace morphcl {

namespace {

void refuse_zero(const ShotValue& value, const glm::dvec3& direction) {
  if (direction == glm::dvec3(0.0))
    value.fail("direction is [0, 0, 0]; it must point from the scene towards the light");
}

// [inner, outer], measured from the axis.
void read_cones(const ShotValue& value, SpotBeam& beam) {
  if (!value.is_array() || value.size() != 2)
    value.fail("cone_degrees must be two numbers: [inner, outer], degrees from the beam's axis");
  beam.inner_cone_degrees = value[0].number();
  beam.outer_cone_degrees = value[1].number();
  if (!(beam.inner_cone_degrees >= 0 && beam.outer_cone_degrees <= 90 &&
        beam.outer_cone_degrees >= beam.inner_cone_degrees + min_cone_edge_degrees))
    value.fail(fmt::format("cone_degrees is [{}, {}]; 0 or more, and from {} more up to 90 degrees, is needed",
                           beam.inner_cone_degrees, beam.outer_cone_degrees, min_cone_edge_degrees));
}

// A light with a target is a spot light.
std::optional<SpotBeam> read_beam(const ShotTable& table, const Light& light) {
  const auto target = table.find("target"), cones = table.find("cone_degrees");
  if (!target && !cones) return std::nullopt;
  if (!target) cones->fail("cone_degrees belongs to a spot light, which has a position and a target");
  if (light.kind != LightKind::point)
    target->fail("a light with a target, a spot light, has a position, not a direction");
  SpotBeam beam;
  beam.target = target->point();
  if (beam.target == light.vector) target->fail("the spot light stands at its target; a beam needs a direction");
  if (cones) read_cones(*cones, beam);
  return beam;
}

void read_light_track(const ShotValue& value, double intensity, TrackReader& tracks, Light& light) {
  const ShotTable table = TrackReader::table(value);
  const ShotValue target = TrackReader::target(table);
  const std::string& name = target.text();
  const std::string_view vector_name = light.kind == LightKind::point ? "position" : "direction";
  const bool aims = light.spot && name == "target";
  if (name != vector_name && name != "color" && !aims)
    target.fail(fmt::format(
        "a light has no value \"{}\" to move{}", name,
        light.spot ? suggestion(name, {vector_name, "target", "color"}) : suggestion(name, {vector_name, "color"})));
  Track& track = aims ? light.spot->target_track : name == "color" ? light.color_track : light.vector_track;
  if (!track.empty()) target.fail(fmt::format("{} is driven twice", name));
  track = name == "color" ? tracks.read(table, KeyValue::color, intensity) : tracks.read(table, KeyValue::point);
}

}  // namespace

Light read_light(const ShotValue& value, std::size_t index, TrackReader& tracks, ParentLinks& parents) {
  const ShotTable table = value.table(
      {"direction", "position", "color", "intensity", "falloff", "target", "cone_degrees", "parent", "track"});
  if (const auto parent = table.find("parent")) parents.hang_light(*parent, index);
  const auto direction = table.find("direction"), position = table.find("position");
  if (direction.has_value() == position.has_value()) value.fail("a light needs either a direction or a position");

  Light light;
  light.kind = position ? LightKind::point : LightKind::directional;
  light.vector = position ? position->point() : direction->point();
  if (direction) refuse_zero(*direction, light.vector);

  light.spot = read_beam(table, light);

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
