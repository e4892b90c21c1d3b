#include "host/scene/shot/shot_projection.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "host/scene/shot/nearest_name.hpp"
#include "morphcl/numerics.hpp"

namespace morphcl {

namespace {

constexpr ProjectionKind kinds[] = {
    {"perspective", ProjectionForm::perspective}, {"frustum", ProjectionForm::frustum},
    {"central", ProjectionForm::central},         {"orthographic", ProjectionForm::orthographic},
    {"oblique", ProjectionForm::oblique},         {"cavalier", ProjectionForm::oblique},
    {"cabinet", ProjectionForm::oblique},         {"isometric", ProjectionForm::axonometric},
    {"dimetric", ProjectionForm::axonometric},    {"trimetric", ProjectionForm::axonometric},
};

// Keys that only some projections have.
struct KeyUse {
  std::string_view key;
  std::vector<std::string_view> kinds;
};

const std::vector<KeyUse>& key_uses() {
  static const std::vector<std::string_view> windows = {"frustum", "central",   "orthographic", "oblique",  "cavalier",
                                                        "cabinet", "isometric", "dimetric",     "trimetric"};
  static const std::vector<std::string_view> placed = {"perspective", "frustum",  "central", "orthographic",
                                                       "oblique",     "cavalier", "cabinet"};
  static const std::vector<KeyUse> uses = {
      {"fovy_degrees", {"perspective"}},
      {"fovx_degrees", {"perspective"}},
      {"focal_length", {"perspective"}},
      {"film", {"perspective"}},
      {"left", windows},
      {"right", windows},
      {"bottom", windows},
      {"top", windows},
      {"fit", windows},
      {"factor", {"oblique"}},
      {"beta_degrees", {"oblique"}},
      {"projectors", {"oblique"}},
      {"direction_degrees", {"oblique", "cavalier", "cabinet"}},
      {"ratios", {"dimetric", "trimetric"}},
      {"axis_angles_degrees", {"trimetric"}},
      {"azimuth_degrees", {"trimetric"}},
      {"elevation_degrees", {"dimetric", "trimetric"}},
      {"corner", {"isometric", "dimetric", "trimetric"}},
      {"eye", placed},
      {"up", placed},
      {"view", placed},
      {"direction", placed},
  };
  return uses;
}

bool contains(const std::vector<std::string_view>& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
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

void refuse_both(const ShotTable& table, const char* key, const char* other) {
  if (table.has(key) && table.has(other))
    table.need(other).fail(fmt::format("{} and {} are both given; one says it all", key, other));
}

struct Distances {
  bool perspective;
  bool placed;  // what is not given is the default's; else it will be fitted
};

void read_near_far(const ShotTable& table, const Distances& distances, double& near, double& far) {
  const bool perspective = distances.perspective;
  if (const auto value = table.find("near")) near = perspective ? value->positive() : value->number();
  if (const auto value = table.find("far")) far = perspective ? value->number_or_infinity() : value->number();
  if (!distances.placed && table.has("near") != table.has("far") && !(near < far)) {
    if (table.has("near"))
      far = near + std::abs(near) + 1;
    else
      near = far > 0 ? 0.5 * far : far - std::abs(far) - 1;
  }
  if (!(near < far))
    place_for(table, "far", "near")
        .fail(fmt::format("near is {} and far is {}; far must be greater than near", near, far));
}

Fit read_fit(const ShotValue& value) {
  const std::string& name = value.text();
  if (name == "stretch") return Fit::stretch;
  if (name == "widen") return Fit::widen;
  if (name == "crop") return Fit::crop;
  if (name == "adjust_x") return Fit::adjust_x;
  if (name == "adjust_y") return Fit::adjust_y;
  value.fail(fmt::format("unknown fit \"{}\"{}", name,
                         suggestion(name, {"stretch", "widen", "crop", "adjust_x", "adjust_y"})));
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
  if (const auto fit = table.find("fit")) planes.fit = read_fit(*fit);
}

// [width, height] of the film, in the unit of the focal length.
glm::dvec2 read_film(const ShotTable& table) {
  const auto film = table.find("film");
  if (!film) return {36, 24};
  if (!film->is_array() || film->size() != 2) film->fail("film must be two numbers: [width, height]");
  return {(*film)[0].positive(), (*film)[1].positive()};
}

// The lens of a camera with a film: the field of view is that of the film's height, 2 atan(h / 2f).
Perspective read_lens(const ShotTable& table) {
  for (const char* key : {"fovy_degrees", "fovx_degrees"}) refuse_both(table, "focal_length", key);
  const double focal_length = table.need("focal_length").positive(), half = 0.5 * read_film(table).y;
  Perspective lens;
  lens.fovy_degrees = 2 * degrees(arc_tangent(half, focal_length));
  if (!(lens.fovy_degrees > 0 && lens.fovy_degrees < 180))
    table.need("focal_length")
        .fail(fmt::format("focal_length is {} and half of the film {}: no field of view", focal_length, half));
  return lens;
}

Projection read_perspective(const ShotTable& table, bool placed) {
  if (table.has("focal_length")) {
    Perspective lens = read_lens(table);
    read_near_far(table, {true, placed}, lens.near, lens.far);
    return lens;
  }
  if (const auto film = table.find("film")) film->fail("film belongs to a focal_length; give both");
  refuse_both(table, "fovy_degrees", "fovx_degrees");
  if (const auto fovx = table.find("fovx_degrees")) {
    HorizontalPerspective perspective;
    perspective.fovx_degrees = fovx->field_of_view();
    read_near_far(table, {true, placed}, perspective.near, perspective.far);
    return perspective;
  }
  Perspective perspective;
  if (const auto fovy = table.find("fovy_degrees")) perspective.fovy_degrees = fovy->field_of_view();
  read_near_far(table, {true, placed}, perspective.near, perspective.far);
  return perspective;
}

template <typename SixPlanes>
Projection read_six_planes(const ShotTable& table, const Distances& distances, SixPlanes planes) {
  read_window(table, planes);
  read_near_far(table, distances, planes.near, planes.far);
  return planes;
}

ObliqueShear read_shear(const ShotTable& table, std::string_view kind) {
  double direction_degrees = 45, factor = kind == "cabinet" ? cabinet_factor : cavalier_factor;
  read_number(table, "direction_degrees", direction_degrees);
  if (kind != "oblique") return oblique_shear(direction_degrees, factor);
  refuse_both(table, "factor", "beta_degrees");
  if (const auto projectors = table.find("projectors")) {
    for (const char* key : {"factor", "beta_degrees", "direction_degrees"}) refuse_both(table, "projectors", key);
    return placed_at(*projectors, [&] { return oblique_shear_along(projectors->point()); });
  }
  if (!table.has("factor") && !table.has("beta_degrees"))
    table.value().fail(
        "an oblique projection needs a factor, beta_degrees or projectors: 1 or 45 is cavalier, 0.5 is cabinet");
  return placed_at(place_for(table, "factor", "beta_degrees"), [&] {
    if (const auto beta = table.find("beta_degrees")) factor = oblique_factor(beta->number());
    read_number(table, "factor", factor);
    return oblique_shear(direction_degrees, factor);
  });
}

ViewDirection read_dimetric(const ShotTable& table) {
  refuse_both(table, "ratios", "elevation_degrees");
  if (const auto elevation = table.find("elevation_degrees")) return view_from_angles(45, elevation->number());
  const auto ratios = table.find("ratios");
  if (!ratios) return view_from_ratios({1, 1, 0.5});
  const glm::dvec3 r = ratios->vector();
  const int equal = (r.x == r.y) + (r.y == r.z) + (r.z == r.x);
  if (equal != 1)
    ratios->fail(equal == 0
                     ? "the ratios of a dimetric projection must have two equal ones; trimetric takes any"
                     : "the ratios of a dimetric projection must have a different one; isometric has three equal");
  return view_from_ratios(r);
}

ViewDirection read_trimetric(const ShotTable& table) {
  refuse_both(table, "ratios", "axis_angles_degrees");
  for (const char* angle : {"azimuth_degrees", "elevation_degrees"}) {
    refuse_both(table, "ratios", angle);
    refuse_both(table, "axis_angles_degrees", angle);
  }
  if (const auto ratios = table.find("ratios")) return view_from_ratios(ratios->vector());
  if (const auto angles = table.find("axis_angles_degrees")) {
    if (!angles->is_array() || angles->size() != 2)
      angles->fail(
          "axis_angles_degrees must be two numbers: how far the x and the z axis are drawn below the horizontal");
    return view_from_axis_angles((*angles)[0].number(), (*angles)[1].number());
  }
  if (!table.has("azimuth_degrees") && !table.has("elevation_degrees"))
    table.value().fail(
        "a trimetric projection needs ratios, axis_angles_degrees, or azimuth_degrees and elevation_degrees");
  return view_from_angles(table.need("azimuth_degrees").number(), table.need("elevation_degrees").number());
}

ViewDirection read_direction(const ShotTable& table, std::string_view kind) {
  if (kind == "dimetric") return read_dimetric(table);
  if (kind == "trimetric") return read_trimetric(table);
  return view_from_ratios(glm::dvec3(1.0));
}

}  // namespace

ProjectionKind read_projection_kind(const ShotTable& camera) {
  const auto projection = camera.find("projection");
  const std::string name = projection ? projection->text() : "perspective";
  const auto kind = std::find_if(std::begin(kinds), std::end(kinds), [&](const auto& k) { return k.name == name; });
  if (kind == std::end(kinds)) {
    std::vector<std::string_view> known;
    for (const ProjectionKind& k : kinds) known.push_back(k.name);
    projection->fail(fmt::format("unknown projection \"{}\"{}", name, suggestion(name, known)));
  }
  for (const KeyUse& use : key_uses())
    if (const auto value = camera.find(use.key); value && !contains(use.kinds, name))
      value->fail(fmt::format("the projection \"{}\" has no {}", name, use.key));
  return *kind;
}

Projection read_projection(const ShotTable& camera, const ProjectionKind& kind, double target_distance, bool placed) {
  // Drawings show what is on both sides of their plane, undistorted.
  constexpr double side = 2, depth = 100;
  switch (kind.form) {
    case ProjectionForm::perspective:
      break;
    case ProjectionForm::frustum:
      return read_six_planes(camera, {true, placed}, Frustum{});
    case ProjectionForm::central:
      return read_six_planes(camera, {true, placed},
                             CentralProjection{-side, side, -side, side, 0.1, depth, target_distance});
    case ProjectionForm::orthographic:
      return read_six_planes(camera, {false, placed}, Orthographic{});
    case ProjectionForm::oblique:
      return read_six_planes(
          camera, {false, placed},
          Oblique{-side, side, -side, side, -depth, depth, read_shear(camera, kind.name), target_distance});
    case ProjectionForm::axonometric:
      return read_six_planes(camera, {false, placed},
                             Orthographic{-side, side, -side, side, -depth, depth, Fit::widen});
  }
  return read_perspective(camera, placed);
}

ViewDirection read_axonometric_direction(const ShotTable& camera, const ProjectionKind& kind) {
  const ViewDirection direction = placed_at(camera.value(), [&] { return read_direction(camera, kind.name); });
  const auto corner = camera.find("corner");
  return corner ? placed_at(*corner, [&] { return seen_from_corner(direction, corner->vector()); }) : direction;
}

}  // namespace morphcl
