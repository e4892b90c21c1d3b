#include "host/scene/shot/formula_mesh.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>
#include <vector>

#include "morphcl/solids.hpp"

namespace morphcl {

namespace {

constexpr int standard_around = 64, standard_along_curve = 10;

struct Cuts {
  int u, v;
};

Cuts read_cuts(const ShotTable& object, Cuts standard) {
  const auto segments = object.find("segments");
  if (!segments) return standard;
  if (!segments->is_array() || segments->size() != 2) segments->fail("segments must be two integers: [u, v]");
  const auto count = [&](std::size_t i) {
    const std::int64_t value = (*segments)[i].integer();
    if (value < 1 || value > max_solid_vertices)
      segments->fail(fmt::format("segments holds {}; 1 or more is needed", value));
    return static_cast<int>(value);
  };
  const int u = count(0);
  return {u, count(1)};
}

std::vector<glm::dvec2> read_profile(const ShotValue& list) {
  const char* form = "profile must be a list of points [radius, y], downwards on the outside";
  if (!list.is_array()) list.fail(form);
  std::vector<glm::dvec2> profile;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const ShotValue point = list[i];
    if (!point.is_array() || point.size() != 2) point.fail(form);
    const double radius = point[0].number();
    if (radius < 0) point[0].fail(fmt::format("the radius is {}; 0 or more is needed", radius));
    profile.emplace_back(radius, point[1].number());
  }
  return profile;
}

// Each piece in `count` equal ones.
std::vector<glm::dvec2> cut(const std::vector<glm::dvec2>& profile, int count) {
  std::vector<glm::dvec2> result;
  for (std::size_t i = 0; i < profile.size(); ++i) {
    result.push_back(profile[i]);
    if (i + 1 == profile.size()) break;
    for (int j = 1; j < count; ++j)
      result.push_back(profile[i] + (static_cast<double>(j) / count) * (profile[i + 1] - profile[i]));
  }
  return result;
}

Mesh read_revolution(const ShotTable& object) {
  const ShotValue list = object.need("profile");
  const Cuts cuts = read_cuts(object, {standard_around, 1});
  const std::vector<glm::dvec2> profile = read_profile(list);
  if (profile.size() > static_cast<std::size_t>(max_solid_vertices / cuts.v))
    object.need("segments")
        .fail(fmt::format("segments make more than the {} vertices that are allowed", max_solid_vertices));
  return placed_at(list, [&] { return make_revolution(cut(profile, cuts.v), cuts.u); });
}

Mesh read_curve(const ShotTable& object) {
  const ShotValue list = object.need("points");
  if (const auto shading = object.find("shading"); shading && shading->text() != "wireframe")
    shading->fail("a curve is drawn as lines: its shading is \"wireframe\"");
  const Cuts cuts = read_cuts(object, {standard_along_curve, 1});
  if (cuts.v != 1) object.need("segments").fail("a curve has segments in one direction: [u, 1]");
  if (!list.is_array()) list.fail("points must be a list of points [x, y, z]");
  std::vector<glm::dvec3> points;
  for (std::size_t i = 0; i < list.size(); ++i) points.push_back(list[i].point());
  return placed_at(list, [&] { return make_curve(points, cuts.u); });
}

}  // namespace

bool is_formula_mesh(std::string_view name) { return name == "revolution" || name == "curve"; }

Mesh read_formula_mesh(const ShotTable& object) {
  return object.need("mesh").text() == "curve" ? read_curve(object) : read_revolution(object);
}

void refuse_other_formulas(const ShotTable& object) {
  const std::string& mesh = object.need("mesh").text();
  if (const auto profile = object.find("profile"); profile && mesh != "revolution")
    profile->fail("profile belongs to the mesh \"revolution\"");
  if (const auto points = object.find("points"); points && mesh != "curve")
    points->fail("points belong to the mesh \"curve\"");
}

std::string formula_text(const ShotTable& object) {
  std::string text;
  if (const auto profile = object.find("profile"))
    for (const glm::dvec2& point : read_profile(*profile)) text += fmt::format("\nprofile {} {}", point.x, point.y);
  if (const auto points = object.find("points"); points && points->is_array())
    for (std::size_t i = 0; i < points->size(); ++i) {
      const glm::dvec3 point = (*points)[i].point();
      text += fmt::format("\npoint {} {} {}", point.x, point.y, point.z);
    }
  return text;
}

}  // namespace morphcl
