#include "morphcl/solids.hpp"

#include <fmt/format.h>

#include "morphcl/error.hpp"

namespace morphcl {

namespace {

struct Request {
  const SolidInfo* solid;
  Segments segments;
  long long vertices;
};

// Of a mesh that is `grids` grids of u x v quads.
template <int grids>
long long grid_vertices(Segments segments) {
  return grids * (segments.u + 1LL) * (segments.v + 1LL);
}

// What `name` and `segments` ask for, checked.
Request checked(std::string_view name, std::optional<Segments> given) {
  const SolidInfo* solid = find_solid(name);
  if (!solid) throw Error(ErrorKind::usage, "", fmt::format("there is no built-in solid \"{}\"", name));
  const Segments minimum = solid->minimum, segments = given.value_or(solid->standard);
  if (given && minimum.u == 0)
    throw Error(ErrorKind::usage, "", fmt::format("the solid \"{}\" takes no segments", name));
  if (segments.u < minimum.u || segments.v < minimum.v)
    throw Error(ErrorKind::usage, "",
                fmt::format("segments [{}, {}] are too few; \"{}\" needs at least [{}, {}]", segments.u, segments.v,
                            name, minimum.u, minimum.v));
  const bool countable =
      segments.u < max_solid_vertices && segments.v < max_solid_vertices;  // the product fits 64 bits
  const long long vertices = countable ? solid->vertices(segments) : 0;
  if (!countable || vertices > max_solid_vertices)
    throw Error(ErrorKind::usage, "",
                fmt::format("segments [{}, {}] make more than the {} vertices that are allowed", segments.u, segments.v,
                            max_solid_vertices));
  return {solid, segments, vertices};
}

}  // namespace

const std::vector<SolidInfo>& solids() {
  static const std::vector<SolidInfo> all = {
      {"pyramid_to_cube",
       {0, 0},
       {0, 0},
       grid_vertices<8>,
       "a pyramid with the morph target \"cube\", a box",
       [](Segments) { return make_pyramid_to_cube(); }},
      {"cube", {0, 0}, {0, 0}, grid_vertices<24>, "a cube of half-edge 1", [](Segments) { return make_cube(); }},
      {"sphere", {3, 2}, {64, 32}, grid_vertices<1>, "a sphere of radius 1", make_sphere},
      {"sphere_to_cube",
       {3, 2},
       {64, 32},
       sphere_to_cube_vertices,
       "a sphere of a cube's six faces, with the morph target \"cube\"",
       make_sphere_to_cube},
      {"torus", {3, 3}, {64, 32}, grid_vertices<1>, "a ring of radius 0.7 with a tube of radius 0.3", make_torus},
      {"cylinder",
       {3, 1},
       {64, 1},
       [](Segments s) { return (s.u + 1LL) * (s.v + 5LL); },
       "a cylinder of radius 1, y from -1 to 1",
       make_cylinder},
      {"cone",
       {3, 1},
       {64, 1},
       [](Segments s) { return (s.u + 1LL) * (s.v + 5LL); },
       "a cone of radius 1, y from -1 to 1, with the triangles of the cylinder",
       make_cone},
      {"prism",
       {3, 1},
       {6, 1},
       [](Segments s) { return 2LL * s.u * (s.v + 1LL) + 2 * (s.u + 1LL); },
       "a prism of u sides, corners at radius 1, y from -1 to 1",
       make_prism},
      {"grid", {1, 1}, {10, 10}, grid_vertices<1>, "a square of half-edge 1 in the xz plane", make_grid},
      {"teapot",
       {1, 1},
       {10, 10},
       grid_vertices<36>,
       "Newell's teapot; segments are those of each of its 32 patches",
       make_teapot},
  };
  return all;
}

const SolidInfo* find_solid(std::string_view name) {
  for (const SolidInfo& solid : solids())
    if (solid.name == name) return &solid;
  return nullptr;
}

long long solid_vertices(std::string_view name, std::optional<Segments> segments) {
  return checked(name, segments).vertices;
}

Mesh make_solid(std::string_view name, std::optional<Segments> segments) {
  const Request request = checked(name, segments);
  return request.solid->make(request.segments);
}

}  // namespace morphcl
