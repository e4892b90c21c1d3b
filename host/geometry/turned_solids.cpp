// What turns about the y axis: cylinder, cone and surfaces of revolution.
#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "host/geometry/circle.hpp"
#include "host/geometry/grid_topology.hpp"
#include "host/math/direction.hpp"
#include "morphcl/error.hpp"
#include "morphcl/solids.hpp"

namespace morphcl {

namespace {

// A circle of the profile and the normal there, (radius, y) both.
struct SweptRing {
  glm::dvec2 place, normal;
};

void append_swept_ring(const SweptRing& ring, const std::vector<SinCos>& around, Mesh& mesh) {
  for (const SinCos& phi : around) {
    mesh.positions.emplace_back(ring.place.x * phi.sin, ring.place.y, ring.place.x * phi.cos);
    mesh.normals.emplace_back(ring.normal.x * phi.sin, ring.normal.y, ring.normal.x * phi.cos);
  }
}

// Outwards of a piece of a profile that runs downwards on the outside.
glm::dvec2 outwards(const glm::dvec2& from, const glm::dvec2& to) {
  const glm::dvec2 along = to - from;
  return glm::dvec2(unit(glm::dvec3(-along.y, along.x, 0)));
}

// One grid of rings; the bands between the rims of the caps and of the side are left out.
Mesh make_capped(const char* name, double upper_radius, Segments segments) {
  Mesh mesh;
  mesh.name = name;
  const std::vector<SinCos> around = circle(segments.u, 360);
  const glm::dvec2 rim(upper_radius, 1), base(1, -1), up(0, 1), down(0, -1), side = outwards(rim, base);
  std::vector<SweptRing> rings = {{{0, 1}, up}, {rim, up}};
  for (int j = 0; j <= segments.v; ++j) {
    const double t = static_cast<double>(j) / segments.v;
    rings.push_back({{upper_radius + t * (1 - upper_radius), 1 - 2 * t}, side});
  }
  rings.insert(rings.end(), {{base, down}, {{0, -1}, down}});
  for (const SweptRing& ring : rings) append_swept_ring(ring, around, mesh);
  const auto row = static_cast<glm::uint>(segments.u + 1), rows = static_cast<glm::uint>(segments.v);
  append_grid_triangles({segments.u, 1}, 0, {.first = true}, false, mesh.triangles);
  append_grid_triangles(segments, 2 * row, {}, false, mesh.triangles);
  append_grid_triangles({segments.u, 1}, (rows + 3) * row, {.last = true}, false, mesh.triangles);
  return mesh;
}

bool sweeps_an_area(const glm::dvec2& from, const glm::dvec2& to) { return from != to && (from.x > 0 || to.x > 0); }

std::size_t check_profile(std::span<const glm::dvec2> profile, int u) {
  const auto refuse = [](const std::string& message) { throw Error(ErrorKind::usage, "", message); };
  if (profile.size() < 2) refuse(fmt::format("a profile of {} points; two or more are needed", profile.size()));
  std::size_t bands = 0;
  for (std::size_t i = 0; i < profile.size(); ++i) {
    if (!std::isfinite(profile[i].x) || !std::isfinite(profile[i].y))
      refuse(fmt::format("point {} of the profile is not finite", i));
    if (profile[i].x < 0)
      refuse(fmt::format("point {} of the profile has the radius {}; 0 or more is needed", i, profile[i].x));
    if (i > 0) bands += sweeps_an_area(profile[i - 1], profile[i]) ? 1 : 0;
  }
  if (bands == 0) refuse("the profile sweeps no area; it needs a piece that is not on the axis");
  if (u < 3) refuse(fmt::format("{} pieces around; 3 or more are needed", u));
  if (bands > static_cast<std::size_t>(max_solid_vertices) / 2 / (static_cast<std::size_t>(u) + 1))
    refuse(fmt::format("{} bands of {} pieces make more than the {} vertices that are allowed", bands, u,
                       max_solid_vertices));
  return bands;
}

}  // namespace

Mesh make_cylinder(Segments segments) { return make_capped("cylinder", 1, segments); }

Mesh make_cone(Segments segments) { return make_capped("cone", 0, segments); }

Mesh make_revolution(std::span<const glm::dvec2> profile, int u) {
  const std::size_t bands = check_profile(profile, u);
  Mesh mesh;
  mesh.name = "revolution";
  const std::vector<SinCos> around = circle(u, 360);
  mesh.positions.reserve(2 * bands * around.size());
  mesh.normals.reserve(2 * bands * around.size());
  for (std::size_t i = 0; i + 1 < profile.size(); ++i) {
    const glm::dvec2 &from = profile[i], &to = profile[i + 1];
    if (!sweeps_an_area(from, to)) continue;
    const auto first = static_cast<glm::uint>(mesh.positions.size());
    const glm::dvec2 normal = outwards(from, to);
    append_swept_ring({from, normal}, around, mesh);
    append_swept_ring({to, normal}, around, mesh);
    append_grid_triangles({u, 1}, first, {.first = from.x == 0, .last = to.x == 0}, false, mesh.triangles);
  }
  return mesh;
}

}  // namespace morphcl
