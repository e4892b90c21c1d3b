#include "host/scene/shot/shot_camera.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "host/math/direction.hpp"
#include "host/scene/model/authored_camera.hpp"
#include "host/scene/model/named_view.hpp"
#include "host/scene/shot/nearest_name.hpp"
#include "host/scene/shot/shot_projection.hpp"
#include "host/scene/shot/vanishing_marks.hpp"
#include "morphcl/camera.hpp"

namespace morphcl {

namespace {

constexpr double standard_distance = 10;  // from the target, of cameras that are placed by a direction

// Where the camera stands is left to fit_camera() unless one of these keys or tracks says it.
bool is_placed(const ShotTable& table) {
  for (const char* key : {"eye", "target", "distance", "left", "right", "bottom", "top"})
    if (table.has(key)) return true;
  bool moves = false;
  table.for_each("track", [&](const ShotValue& track) {
    const std::string target = TrackReader::target(TrackReader::table(track)).text();
    moves |= target == "eye" || target == "target" || target == "up";
  });
  return moves;
}

ViewDirection read_view(const ShotValue& value) {
  if (const auto view = view_named(value.text())) return *view;
  value.fail(no_such_view(value.text()));
}

glm::dvec3 read_up(const ShotTable& table) {
  const auto up = table.find("up");
  if (!up) return {0, 1, 0};
  const glm::dvec3 vector = up->point();
  if (vector == glm::dvec3(0.0)) up->fail("up is [0, 0, 0]; it must have a direction");
  return vector;
}

// The direction that the table gives instead of an eye, by its name or by a vector, if any.
std::optional<ViewDirection> read_direction(const ShotTable& table, const ProjectionKind& kind) {
  if (kind.form == ProjectionForm::axonometric) return read_axonometric_direction(table, kind);
  const auto view = table.find("view"), direction = table.find("direction");
  const auto refuse = [&](const char* given, std::initializer_list<const char*> keys) {
    for (const char* key : keys)
      if (const auto value = table.find(key))
        value->fail(fmt::format("{} says where the camera stands; {} must not be given", given, key));
  };
  if (view) {
    refuse("view", {"eye", "up", "direction"});
    return read_view(*view);
  }
  if (!direction) return std::nullopt;
  refuse("direction", {"eye"});
  const glm::dvec3 towards_eye = direction->point();
  if (towards_eye == glm::dvec3(0.0))
    direction->fail("direction is [0, 0, 0]; it must point from the target to the eye");
  return ViewDirection{unit(towards_eye), read_up(table)};
}

// Drawings show a side in its true shape.
std::string_view usual_view(const ProjectionKind& kind) {
  return kind.form == ProjectionForm::central || kind.form == ProjectionForm::oblique ? "front" : "three_quarter";
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
  if (const auto eye = table.find("eye")) camera.eye = eye->point();
  if (camera.eye == camera.target)
    (table.has("eye") ? table.need("eye") : table.need("target")).fail("eye and target are the same point");
  camera.up = read_up(table);
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
  const std::array<Driven, 7> all = {{{"eye", &camera.eye_track, KeyValue::point},
                                      {"target", &camera.target_track, KeyValue::point},
                                      {"up", &camera.up_track, KeyValue::point},
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

Camera model_camera(const ShotTable& table, MeshLibrary& library, ParentLinks& parents, Scene& scene) {
  for (const TomlEntry& entry : table.entries())
    if (entry.key != "model" && entry.key != "name" && entry.key != "animation" && entry.key != "parent")
      table.need(entry.key).fail(fmt::format("{} is the model's own where a camera is taken out of one", entry.key));
  ImportedModel model = library.camera_model(table);
  const int first_node = static_cast<int>(scene.timeline.nodes.size());
  const auto parent = table.find("parent");
  for (Node& node : model.nodes) {
    if (node.parent >= 0)
      node.parent += first_node;
    else if (parent)
      parents.hang_node(*parent, static_cast<int>(scene.timeline.nodes.size()));
    scene.timeline.nodes.push_back(std::move(node));
  }
  model.camera->node += first_node;
  keep_authored_view(*model.camera, model.camera_aspect, static_cast<double>(scene.image.width) / scene.image.height);
  return *std::move(model.camera);
}

void refuse_view(const std::optional<std::string>& view, const ShotValue& camera, const char* why) {
  if (view)
    throw Error(ErrorKind::usage, camera.place(),
                fmt::format("--view turns a fitted camera; the shot's {}, so leave --view out", why));
}

}  // namespace

ShotCamera read_camera(const ShotValue& value, const std::optional<std::string>& view, TrackReader& tracks,
                       MeshLibrary& library, ParentLinks& parents, Scene& scene) {
  const ShotTable table = value.table({"eye",
                                       "target",
                                       "up",
                                       "projection",
                                       "fovy_degrees",
                                       "fovx_degrees",
                                       "near",
                                       "far",
                                       "view",
                                       "direction",
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
                                       "focal_length",
                                       "film",
                                       "projectors",
                                       "factor",
                                       "beta_degrees",
                                       "direction_degrees",
                                       "ratios",
                                       "axis_angles_degrees",
                                       "azimuth_degrees",
                                       "elevation_degrees",
                                       "corner",
                                       "mark_vanishing_points",
                                       "parent"});
  if (table.has("model")) {
    refuse_view(view, value, "is a model's");
    return {model_camera(table, library, parents, scene), false};
  }
  for (const char* key : {"name", "animation"})
    if (const auto given = table.find(key)) given->fail(fmt::format("{} belongs to a camera out of a model", key));
  const ProjectionKind kind = read_projection_kind(table);
  const bool placed = is_placed(table);
  if (placed) refuse_view(view, value, "says itself where it stands");
  if (kind.form == ProjectionForm::axonometric) refuse_view(view, value, "has the direction of its projection");
  const std::optional<ViewDirection> direction = read_direction(table, kind);
  ShotCamera result;
  Camera& camera = result.camera;
  double distance = standard_distance;
  if (placed) {
    if (const auto target = table.find("target")) camera.target = target->point();
    distance = direction ? place_along(*direction, table, camera) : place_at_eye(table, camera);
  } else {
    CameraFit& fit = result.fit.emplace();
    fit.view = view ? needed_view(*view) : direction.value_or(needed_view(usual_view(kind)));
    if (!view && !direction && table.has("up")) fit.view.up = read_up(table);
    fit.near = !table.has("near");
    fit.far = !table.has("far");
  }
  camera.projection = read_projection(table, kind, distance, placed);
  placed_at(table.value(), [&] { validate(camera.projection); });
  table.for_each("track",
                 [&](const ShotValue& track) { read_camera_track(track, direction.has_value(), tracks, camera); });
  if (result.fit) {
    result.fit->near &= camera.near_track.empty();
    result.fit->far &= camera.far_track.empty();
  }
  if (const auto parent = table.find("parent")) {
    if (!placed)
      parent->fail("a fitted camera stands still in the world; say by eye and target where it stands below its parent");
    parents.hang_camera(*parent);
  }
  result.marks_vanishing_points = marks_vanishing_points(table, camera);
  return result;
}

ShotCamera fitted_shot_camera(const std::optional<std::string>& view) {
  ShotCamera result;
  CameraFit& fit = result.fit.emplace();
  if (view) fit.view = needed_view(*view);
  return result;
}

}  // namespace morphcl
