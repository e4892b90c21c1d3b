#include "host/scene/obj/obj_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <tuple>

#include "host/scene/obj/polygon_triangulation.hpp"
#include "morphcl/error.hpp"

namespace morphcl {

namespace {

// A normal of length 0 has no direction and is lit from the front.
glm::vec3 unit(const glm::dvec3& normal) {
  const double length = glm::length(normal);
  return length > 0 ? glm::vec3(normal / length) : glm::vec3(0, 0, 1);
}

std::uint64_t vertex_key(const ObjCorner& corner, bool with_normals) {
  return std::uint64_t{corner.position} << 32 | (with_normals ? static_cast<std::uint32_t>(corner.normal) : 0);
}

bool every_corner_has_normal(const ObjFile& file) {
  return std::all_of(file.corners.begin(), file.corners.end(), [](const ObjCorner& c) { return c.normal >= 0; });
}

void number_vertices(const ObjFile& file, bool with_normals, ObjMesh& result) {
  std::vector<std::uint64_t> keys;
  keys.reserve(file.corners.size());
  for (const ObjCorner& corner : file.corners) keys.push_back(vertex_key(corner, with_normals));
  std::sort(keys.begin(), keys.end());
  keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
  for (const std::uint64_t key : keys)
    result.vertices.push_back(
        {static_cast<std::uint32_t>(key >> 32), with_normals ? static_cast<std::int32_t>(key & 0xFFFFFFFF) : -1});
  for (const ObjCorner& corner : file.corners) {
    const auto found = std::lower_bound(keys.begin(), keys.end(), vertex_key(corner, with_normals));
    result.corner_vertices.push_back(static_cast<std::uint32_t>(found - keys.begin()));
  }
}

void cut_faces(const ObjFile& file, ObjMesh& result) {
  std::vector<glm::vec3> polygon;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (const ObjFace& face : file.faces) {
    polygon.clear();
    triangles.clear();
    for (std::uint32_t c = 0; c < face.count; ++c)
      polygon.push_back(file.positions[file.corners[face.first + c].position]);
    if (!triangulate_polygon(polygon, triangles))
      throw Error(ErrorKind::bad_input, fmt::format("{}:{}", file.path, face.line),
                  fmt::format("this face of {} corners is not convex; at most {} corners are cut into triangles",
                              face.count, max_ear_clipping_corners));
    const std::uint32_t* vertex = &result.corner_vertices[face.first];
    for (const auto& [a, b, c] : triangles) result.mesh.triangles.emplace_back(vertex[a], vertex[b], vertex[c]);
  }
}

// The polygons' sides, each once by its positions: along a crease two vertices stand in one place.
std::vector<glm::uvec2> polygon_sides(const ObjFile& file, const ObjMesh& result) {
  struct Side {
    std::uint32_t low, high;  // positions
    glm::uvec2 vertices;
    bool operator<(const Side& other) const {
      return std::tie(low, high, vertices.x, vertices.y) <
             std::tie(other.low, other.high, other.vertices.x, other.vertices.y);
    }
  };
  std::vector<Side> sides;
  sides.reserve(file.corners.size());
  for (const ObjFace& face : file.faces)
    for (std::uint32_t c = 0; c < face.count; ++c) {
      std::uint32_t a = face.first + c, b = face.first + (c + 1) % face.count;
      if (file.corners[a].position > file.corners[b].position) std::swap(a, b);
      sides.push_back(
          {file.corners[a].position, file.corners[b].position, {result.corner_vertices[a], result.corner_vertices[b]}});
    }
  std::sort(sides.begin(), sides.end());
  std::vector<glm::uvec2> edges;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const bool first = i == 0 || sides[i].low != sides[i - 1].low || sides[i].high != sides[i - 1].high;
    if (first && sides[i].low != sides[i].high) edges.push_back(sides[i].vertices);
  }
  return edges;
}

void check_topology(const ObjFile& file, const ObjFile& neutral) {
  if (file.positions.size() != neutral.positions.size())
    throw Error(ErrorKind::bad_input, file.path,
                fmt::format("has {} vertices (v), but {} has {}; a morph target has as many", file.positions.size(),
                            neutral.path, neutral.positions.size()));
  for (std::size_t f = 0; f < file.faces.size(); ++f) {
    const ObjFace& face = file.faces[f];
    const std::string place = fmt::format("{}:{}", file.path, face.line);
    if (f >= neutral.faces.size())
      throw Error(
          ErrorKind::bad_input, place,
          fmt::format("face {} is one more than {} has; a morph target has the same faces", f + 1, neutral.path));
    const ObjFace& model = neutral.faces[f];
    const auto same = [](const ObjCorner& a, const ObjCorner& b) { return a.position == b.position; };
    const auto first = file.corners.begin() + face.first, model_first = neutral.corners.begin() + model.first;
    if (!std::equal(first, first + face.count, model_first, model_first + model.count, same))
      throw Error(ErrorKind::bad_input, place,
                  fmt::format("face {} has other vertices than at {}:{}; a morph target has the same faces", f + 1,
                              neutral.path, model.line));
  }
  if (file.faces.size() < neutral.faces.size())
    throw Error(ErrorKind::bad_input, file.path,
                fmt::format("has {} faces, but {} has {}; a morph target has the same faces", file.faces.size(),
                            neutral.path, neutral.faces.size()));
}

}  // namespace

ObjMesh make_mesh(const ObjFile& file, ImportBudget& budget) {
  ObjMesh result;
  const bool with_normals = every_corner_has_normal(file);
  result.dropped_normals = !with_normals && !file.normals.empty();
  budget.charge(file.corners.size(), sizeof(std::uint64_t) + sizeof(ObjCorner) + sizeof(std::uint32_t), file.path);
  number_vertices(file, with_normals, result);

  Mesh& mesh = result.mesh;
  budget.charge(result.vertices.size(), 2 * sizeof(glm::vec3) + sizeof(glm::vec4), file.path);
  for (const ObjCorner& vertex : result.vertices) {
    mesh.positions.push_back(file.positions[vertex.position]);
    if (with_normals) mesh.normals.push_back(unit(file.normals[static_cast<std::size_t>(vertex.normal)]));
    if (!file.colors.empty()) mesh.colors.emplace_back(glm::clamp(file.colors[vertex.position], 0.0f, 1.0f), 1.0f);
  }
  cut_faces(file, result);
  const auto is_triangle = [](const ObjFace& face) { return face.count == 3; };
  if (with_normals || !std::all_of(file.faces.begin(), file.faces.end(), is_triangle))
    mesh.edges = polygon_sides(file, result);
  return result;
}

MorphTarget make_target(const ObjFile& file, const ObjFile& neutral_file, const ObjMesh& neutral,
                        ImportBudget& budget) {
  check_topology(file, neutral_file);
  budget.charge(neutral.vertices.size(), 2 * sizeof(glm::vec3) + sizeof(glm::dvec3), file.path);
  MorphTarget target;
  target.form = TargetForm::absolute;
  for (const ObjCorner& vertex : neutral.vertices) target.positions.push_back(file.positions[vertex.position]);
  if (neutral.mesh.normals.empty() || !every_corner_has_normal(file)) return target;

  std::vector<glm::dvec3> sums(neutral.vertices.size());
  for (std::size_t c = 0; c < file.corners.size(); ++c)
    sums[neutral.corner_vertices[c]] += unit(file.normals[static_cast<std::size_t>(file.corners[c].normal)]);
  for (const glm::dvec3& sum : sums) target.normals.push_back(unit(sum));
  return target;
}

}  // namespace morphcl
