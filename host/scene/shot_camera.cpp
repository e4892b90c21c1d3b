#include "host/scene/shot_camera.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "host/scene/nearest_name.hpp"

namespace morphcl {

namespace {

constexpr std::array<std::string_view, 6> later_projections = {"oblique",   "cavalier", "cabinet",
                                                               "isometric", "dimetric", "trimetric"};

// Refuses keys that stand in the table although the projection has no use for them.
void refuse_keys(const ShotTable& table, std::string_view projection, std::initializer_list<const char*> keys) {
  for (const char* key : keys)
    if (const auto value = table.find(key))
      value->fail(fmt::format("the projection \"{}\" has no {}", projection, key));
}

// Reads `key` into `number` when it is there.
void read_number(const ShotTable& table, const char* key, double& number) {
  if (const auto value = table.find(key)) number = value->number();
}

// The value of `key`, else of `other`, else of the table: where an error about both is best put.
ShotValue place_for(const ShotTable& table, const char* key, const char* other) {
  if (const auto value = table.find(key)) return *value;
  if (const auto value = table.find(other)) return *value;
  return table.value();
}

void read_near_far(const ShotTable& table, bool perspective, double& near, double& far) {
  if (const auto value = table.find("near")) near = perspective ? value->positive() : value->number();
  if (const auto value = table.find("far")) far = perspective ? value->number_or_infinity() : value->number();
  if (!(near < far))
    place_for(table, "far", "near")
        .fail(fmt::format("near is {} and far is {}; far must be greater than near", near, far));
}

template <typename SixPlanes>
void read_window(const ShotTable& table, SixPlanes& planes) {
  read_number(table, "left", planes.left);
  read_number(table, "right", planes.right);
  read_number(table, "bottom", planes.bottom);
  read_number(table, "top", planes.top);
  if (!(planes.left < planes.right))
    place_for(table, "right", "left")
        .fail(fmt::format("left is {} and right is {}; right must be greater", planes.left, planes.right));
  if (!(planes.bottom < planes.top))
    place_for(table, "top", "bottom")
        .fail(fmt::format("bottom is {} and top is {}; top must be greater", planes.bottom, planes.top));
}

Projection read_perspective(const ShotTable& table) {
  refuse_keys(table, "perspective", {"left", "right", "bottom", "top"});
  Perspective perspective;
  if (const auto fovy = table.find("fovy_degrees")) perspective.fovy_degrees = fovy->field_of_view();
  read_near_far(table, true, perspective.near, perspective.far);
  return perspective;
}

Projection read_frustum(const ShotTable& table) {
  refuse_keys(table, "frustum", {"fovy_degrees"});
  Frustum frustum;
  read_window(table, frustum);
  read_near_far(table, true, frustum.near, frustum.far);
  return frustum;
}

Projection read_orthographic(const ShotTable& table) {
  refuse_keys(table, "orthographic", {"fovy_degrees"});
  Orthographic orthographic;
  read_window(table, orthographic);
  read_near_far(table, false, orthographic.near, orthographic.far);
  return orthographic;
}

Projection read_projection(const ShotTable& table) {
  const auto projection = table.find("projection");
  const std::string name = projection ? projection->text() : "perspective";
  if (name == "perspective") return read_perspective(table);
  if (name == "frustum") return read_frustum(table);
  if (name == "orthographic") return read_orthographic(table);
  if (std::find(later_projections.begin(), later_projections.end(), name) != later_projections.end())
    projection->fail(
        fmt::format("projection \"{}\": not drawn by this version: perspective, frustum and orthographic are", name));
  projection->fail(
      fmt::format("unknown projection \"{}\"{}", name, suggestion(name, {"perspective", "frustum", "orthographic"})));
}

void read_position(const ShotTable& table, Camera& camera) {
  if (const auto eye = table.find("eye")) camera.eye = eye->vector();
  if (const auto target = table.find("target")) camera.target = target->vector();
  if (camera.eye == camera.target) place_for(table, "eye", "target").fail("eye and target are the same point");
  if (const auto up = table.find("up")) {
    camera.up = up->vector();
    if (camera.up == glm::dvec3(0.0)) up->fail("up is [0, 0, 0]; it must have a direction");
  }
}

void read_camera_track(const ShotValue& value, TrackReader& tracks, Camera& camera) {
  const ShotTable table = TrackReader::table(value);
  const ShotValue target = TrackReader::target(table);
  struct Driven {
    std::string_view name;
    Track* track;
    KeyValue kind;
  };
  const std::array<Driven, 6> all = {{{"eye", &camera.eye_track, KeyValue::vector},
                                      {"target", &camera.target_track, KeyValue::vector},
                                      {"up", &camera.up_track, KeyValue::vector},
                                      {"fovy_degrees", &camera.fovy_track, KeyValue::field_of_view},
                                      {"near", &camera.near_track, KeyValue::number},
                                      {"far", &camera.far_track, KeyValue::number}}};
  const std::string& name = target.text();
  const auto driven = std::find_if(all.begin(), all.end(), [&](const Driven& d) { return d.name == name; });
  if (driven == all.end())
    target.fail(fmt::format("a camera has no value \"{}\" to move{}", name,
                            suggestion(name, {"eye", "target", "up", "fovy_degrees", "near", "far"})));
  if (name == "fovy_degrees" && !std::holds_alternative<Perspective>(camera.projection))
    target.fail("only a perspective projection has fovy_degrees");
  if (!driven->track->empty()) target.fail(fmt::format("{} is driven twice", name));
  const bool distance = name == "near" || name == "far";
  *driven->track = tracks.read(table, distance && !is_parallel(camera.projection) ? KeyValue::positive : driven->kind);
}

}  // namespace

Camera read_camera(const ShotValue& value, TrackReader& tracks) {
  const ShotTable table = value.table(
      {"projection", "fovy_degrees", "left", "right", "bottom", "top", "near", "far", "eye", "target", "up", "track"});
  Camera camera;
  camera.projection = read_projection(table);
  read_position(table, camera);
  table.for_each("track", [&](const ShotValue& track) { read_camera_track(track, tracks, camera); });
  return camera;
}

}  // namespace morphcl
