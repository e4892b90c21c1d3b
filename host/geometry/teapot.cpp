#include <array>
#include <cstddef>

#include "host/geometry/grid_topology.hpp"
#include "host/geometry/teapot_patches.hpp"
#include "morphcl/solids.hpp"

namespace morphcl {

namespace {

constexpr double classic_centre_height = 1.5, scale = 0.5;
constexpr glm::uint first_rim_patch = 0, first_lid_patch = 16, upper_handle_patch = 24, lower_handle_patch = 26;
constexpr std::array<std::size_t, 4> spout_patches = {28, 29, 30, 31};

// z up to y up: a quarter turn about x.
glm::dvec3 y_up(const glm::dvec3& p) { return {p.x, p.z, -p.y}; }

bool is_point(const std::array<glm::dvec3, 4>& row) { return row[0] == row[1] && row[0] == row[2] && row[0] == row[3]; }

glm::uint patch_vertices(Segments segments) { return static_cast<glm::uint>((segments.u + 1LL) * (segments.v + 1LL)); }

void append_patch(Mesh& mesh, const BezierPatch& patch, Segments segments) {
  const auto first = static_cast<glm::uint>(mesh.positions.size());
  for (int j = 0; j <= segments.v; ++j)
    for (int i = 0; i <= segments.u; ++i) {
      const SurfacePoint point =
          evaluate_patch(patch, static_cast<double>(i) / segments.u, static_cast<double>(j) / segments.v);
      mesh.positions.emplace_back(scale * y_up(point.position - glm::dvec3(0, 0, classic_centre_height)));
      mesh.normals.emplace_back(y_up(point.normal));
    }
  const CollapsedRows collapsed = {.first = is_point(patch.points.front()), .last = is_point(patch.points.back())};
  append_grid_triangles(segments, first, collapsed, patch.flipped, mesh.triangles);
}

// The ring that the lid rests on, from its edge to the rim: the last row of the lid's patches and the first of the
// rim's, by their vertices.
void append_seat(Mesh& mesh, Segments segments) {
  const glm::uint vertices = patch_vertices(segments), columns = static_cast<glm::uint>(segments.u);
  for (glm::uint quarter = 0; quarter < 4; ++quarter) {
    const glm::uint lid = (first_lid_patch + quarter + 1) * vertices - (columns + 1);
    const glm::uint rim = (first_rim_patch + quarter) * vertices;
    for (glm::uint i = 0; i < columns; ++i) {
      mesh.triangles.emplace_back(lid + i, rim + i, lid + i + 1);
      mesh.triangles.emplace_back(lid + i + 1, rim + i, rim + i + 1);
    }
  }
}

// Closes an end of the handle: a row of both halves, `left` and `right` their first vertices, which meet in the plane
// of symmetry. `reversed`: the last row, not the first one.
void append_cap(Mesh& mesh, glm::uint left, glm::uint right, Segments segments, bool reversed) {
  const auto append = [&](glm::uint a, glm::uint b, glm::uint c) {
    mesh.triangles.push_back(reversed ? glm::uvec3(a, c, b) : glm::uvec3(a, b, c));
  };
  const auto columns = static_cast<glm::uint>(segments.u);
  for (glm::uint i = 0; i < columns; ++i) {
    if (i > 0) append(left + i, right + i, right + i + 1);
    if (i + 1 < columns) append(left + i, right + i + 1, left + i + 1);
  }
}

void append_caps(Mesh& mesh, Segments segments) {
  const glm::uint vertices = patch_vertices(segments), row = static_cast<glm::uint>(segments.u) + 1;
  const glm::uint upper = upper_handle_patch * vertices, lower = lower_handle_patch * vertices;
  append_cap(mesh, upper, upper + vertices, segments, false);
  append_cap(mesh, lower + vertices - row, lower + 2 * vertices - row, segments, true);
}

}  // namespace

Mesh make_teapot(Segments segments) {
  Mesh mesh;
  mesh.name = "teapot";
  const auto& patches = teapot_patches();
  const std::size_t vertices = (patches.size() + spout_patches.size()) * patch_vertices(segments);
  mesh.positions.reserve(vertices);
  mesh.normals.reserve(vertices);
  for (const BezierPatch& patch : patches) append_patch(mesh, patch, segments);
  append_seat(mesh, segments);
  append_caps(mesh, segments);
  for (const std::size_t number : spout_patches) {
    BezierPatch inner = patches[number];
    inner.flipped = !inner.flipped;
    append_patch(mesh, inner, segments);
  }
  return mesh;
}

}  // namespace morphcl
