#include "host/geometry/solids.hpp"

#include <fmt/format.h>

#include "host/error.hpp"

namespace morphcl {

namespace {

// Vertices of one grid; a solid is one grid or, for the teapot, 32.
long long vertex_count(const SolidInfo& solid, Segments segments) {
  const long long grid = (segments.u + 1LL) * (segments.v + 1LL);
  return solid.make == make_teapot ? 32 * grid : grid;
}

}  // namespace

const std::vector<SolidInfo>& solids() {
  static const std::vector<SolidInfo> all = {
      {"pyramid_to_cube",
       {0, 0},
       {0, 0},
       "a pyramid with the morph target \"cube\", a box",
       [](Segments) { return make_pyramid_to_cube(); }},
      {"cube", {0, 0}, {0, 0}, "a cube of half-edge 1", [](Segments) { return make_cube(); }},
      {"sphere", {3, 2}, {64, 32}, "a sphere of radius 1", make_sphere},
      {"sphere_to_cube", {3, 2}, {64, 32}, "a sphere with the morph target \"cube\"", make_sphere_to_cube},
      {"torus", {3, 3}, {64, 32}, "a ring of radius 0.7 with a tube of radius 0.3", make_torus},
      {"grid", {1, 1}, {10, 10}, "a square of half-edge 1 in the xz plane", make_grid},
      {"teapot", {1, 1}, {10, 10}, "Newell's teapot; segments are those of each of its 32 patches", make_teapot},
  };
  return all;
}

const SolidInfo* find_solid(std::string_view name) {
  for (const SolidInfo& solid : solids())
    if (solid.name == name) return &solid;
  return nullptr;
}

Mesh make_solid(std::string_view name, std::optional<Segments> segments) {
  const SolidInfo* solid = find_solid(name);
  if (!solid) throw Error(ErrorKind::usage, "", fmt::format("there is no built-in solid \"{}\"", name));
  if (!segments) return solid->make(solid->standard);
  const Segments minimum = solid->minimum;
  if (minimum.u == 0) throw Error(ErrorKind::usage, "", fmt::format("the solid \"{}\" takes no segments", name));
  if (segments->u < minimum.u || segments->v < minimum.v)
    throw Error(ErrorKind::usage, "",
                fmt::format("segments [{}, {}] are too few; \"{}\" needs at least [{}, {}]", segments->u, segments->v,
                            name, minimum.u, minimum.v));
  const long long vertices = vertex_count(*solid, *segments);
  if (vertices > max_solid_vertices)
    throw Error(ErrorKind::usage, "",
                fmt::format("segments [{}, {}] make {} vertices; at most {} are allowed", segments->u, segments->v,
                            vertices, max_solid_vertices));
  return solid->make(*segments);
}

}  // namespace morphcl
