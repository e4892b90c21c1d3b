#include "host/scene/shot/shot_camera.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <utility>

#include "host/scene/model/authored_camera.hpp"
#include "host/scene/shot/nearest_name.hpp"
#include "host/scene/shot/shot_projection.hpp"
#include "host/scene/shot/vanishing_marks.hpp"
#include "morphcl/camera.hpp"

namespace morphcl {

namespace {

constexpr double standard_distance = 10;  // from the target, of cameras that are placed by a direction

PrincipalView read_view(const ShotValue& value) {
  const std::string& name = value.text();
  if (name == "front") return PrincipalView::front;
  if (name == "back") return PrincipalView::back;
  if (name == "left") return PrincipalView::left;
  if (name == "right") return PrincipalView::right;
  if (name == "top") return PrincipalView::top;
  if (name == "bottom") return PrincipalView::bottom;
  value.fail(fmt::format("unknown view \"{}\"{}", name,
                         suggestion(name, {"front", "back", "left", "right", "top", "bottom"})));
}

// The direction that the table gives by a name instead of eye and up, if any.
std::optional<ViewDirection> read_direction(const ShotTable& table, const ProjectionKind& kind) {
  if (kind.form == ProjectionForm::axonometric) return read_axonometric_direction(table, kind);
  const auto view = table.find("view");
  if (!view) return std::nullopt;
  for (const char* key : {"eye", "up"})
    if (const auto value = table.find(key))
      value->fail(fmt::format("view says where the camera stands; {} must not be given", key));
  return view_direction(read_view(*view));
}

// Places the camera; returns its distance from the target.
double place_along(const ViewDirection& direction, const ShotTable& table, Camera& camera) {
  const auto value = table.find("distance");
  const double distance = value ? value->positive() : standard_distance;
  camera.eye = camera.target + distance * direction.towards_eye;
  camera.up = direction.up;
  if (camera.eye == camera.target)
    (value ? *value : table.value()).fail(fmt::format("distance is {}: too small beside the target", distance));
  return distance;
}

double place_at_eye(const ShotTable& table, Camera& camera) {
  if (const auto distance = table.find("distance"))
    distance->fail("distance belongs to view and to axonometric projections; here eye says where the camera stands");
  if (const auto eye = table.find("eye")) camera.eye = eye->vector();
  if (camera.eye == camera.target)
    (table.has("eye") ? table.need("eye") : table.need("target")).fail("eye and target are the same point");
  if (const auto up = table.find("up")) {
    camera.up = up->vector();
    if (camera.up == glm::dvec3(0.0)) up->fail("up is [0, 0, 0]; it must have a direction");
  }
  return glm::length(camera.eye - camera.target);
}

void read_camera_track(const ShotValue& value, bool by_direction, TrackReader& tracks, Camera& camera) {
  const ShotTable table = TrackReader::table(value);
  const ShotValue target = TrackReader::target(table);
  struct Driven {
    std::string_view name;
    Track* track;
    KeyValue kind;
  };
  const std::array<Driven, 7> all = {{{"eye", &camera.eye_track, KeyValue::vector},
                                      {"target", &camera.target_track, KeyValue::vector},
                                      {"up", &camera.up_track, KeyValue::vector},
                                      {"fovy_degrees", &camera.fovy_track, KeyValue::field_of_view},
                                      {"fovx_degrees", &camera.fovx_track, KeyValue::field_of_view},
                                      {"near", &camera.near_track, KeyValue::number},
                                      {"far", &camera.far_track, KeyValue::number}}};
  const std::string& name = target.text();
  const auto driven = std::find_if(all.begin(), all.end(), [&](const Driven& d) { return d.name == name; });
  if (driven == all.end())
    target.fail(fmt::format("a camera has no value \"{}\" to move{}", name,
                            suggestion(name, {"eye", "target", "up", "fovy_degrees", "fovx_degrees", "near", "far"})));
  if (name == "fovy_degrees" && !std::holds_alternative<Perspective>(camera.projection))
    target.fail("only a perspective projection has fovy_degrees, and only one without fovx_degrees");
  if (name == "fovx_degrees" && !std::holds_alternative<HorizontalPerspective>(camera.projection))
    target.fail("only a perspective projection that has fovx_degrees can move it");
  const bool moves_camera = name == "eye" || name == "target" || name == "up";
  if (moves_camera && by_direction)
    target.fail(fmt::format("{} cannot move a camera that is placed by its view; give eye, target and up", name));
  if (!driven->track->empty()) target.fail(fmt::format("{} is driven twice", name));
  const bool distance = name == "near" || name == "far";
  *driven->track = tracks.read(table, distance && !is_parallel(camera.projection) ? KeyValue::positive : driven->kind);
}

Camera model_camera(const ShotTable& table, MeshLibrary& library, Scene& scene) {
  for (const TomlEntry& entry : table.entries())
    if (entry.key != "model" && entry.key != "name" && entry.key != "animation")
      table.need(entry.key).fail(fmt::format("{} is the model's own where a camera is taken out of one", entry.key));
  ImportedModel model = library.camera_model(table);
  const int first_node = static_cast<int>(scene.timeline.nodes.size());
  for (Node& node : model.nodes) {
    if (node.parent >= 0) node.parent += first_node;
    scene.timeline.nodes.push_back(std::move(node));
  }
  model.camera->node += first_node;
  keep_authored_view(*model.camera, model.camera_aspect, static_cast<double>(scene.image.width) / scene.image.height);
  return *std::move(model.camera);
}

}  // namespace

ShotCamera read_camera(const ShotValue& value, TrackReader& tracks, MeshLibrary& library, Scene& scene) {
  const ShotTable table = value.table({"eye",
                                       "target",
                                       "up",
                                       "projection",
                                       "fovy_degrees",
                                       "fovx_degrees",
                                       "near",
                                       "far",
                                       "view",
                                       "distance",
                                       "model",
                                       "track",
                                       "name",
                                       "animation",
                                       "left",
                                       "right",
                                       "bottom",
                                       "top",
                                       "fit",
                                       "factor",
                                       "beta_degrees",
                                       "direction_degrees",
                                       "ratios",
                                       "axis_angles_degrees",
                                       "azimuth_degrees",
                                       "elevation_degrees",
                                       "corner",
                                       "mark_vanishing_points"});
  if (table.has("model")) return {model_camera(table, library, scene), false};
  for (const char* key : {"name", "animation"})
    if (const auto given = table.find(key)) given->fail(fmt::format("{} belongs to a camera out of a model", key));
  Camera camera;
  const ProjectionKind kind = read_projection_kind(table);
  if (const auto target = table.find("target")) camera.target = target->vector();
  const std::optional<ViewDirection> direction = read_direction(table, kind);
  const double distance = direction ? place_along(*direction, table, camera) : place_at_eye(table, camera);
  camera.projection = read_projection(table, kind, distance);
  placed_at(table.value(), [&] { validate(camera.projection); });
  table.for_each("track",
                 [&](const ShotValue& track) { read_camera_track(track, direction.has_value(), tracks, camera); });
  const bool marks = marks_vanishing_points(table, camera);
  return {std::move(camera), marks};
}

}  // namespace morphcl
