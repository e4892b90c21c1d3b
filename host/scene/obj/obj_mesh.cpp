#include "host/scene/obj/obj_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <tuple>

#include "host/scene/obj/polygon_triangulation.hpp"
#include "morphcl/error.hpp"

namespace morphcl {

namespace {

glm::dvec3 unit(const glm::dvec3& normal) {
  const double length = glm::length(normal);
  return length > 0 ? normal / length : glm::dvec3(0, 0, 1);  // a target's normals may cancel each other
}

// The one rounding of a normal to what a mesh stores.
glm::vec3 stored_normal(const glm::dvec3& normal) { return glm::vec3(unit(normal)); }

bool comes_before(const ObjCorner& a, const ObjCorner& b) {
  return std::tie(a.position, a.normal, a.uv) < std::tie(b.position, b.normal, b.uv);
}

bool same_vertex(const ObjCorner& a, const ObjCorner& b) {
  return a.position == b.position && a.normal == b.normal && a.uv == b.uv;
}

void number_vertices(const std::vector<ObjCorner>& corners, ObjMesh& result) {
  std::vector<ObjCorner>& vertices = result.vertices;
  vertices = corners;
  std::sort(vertices.begin(), vertices.end(), comes_before);
  vertices.erase(std::unique(vertices.begin(), vertices.end(), same_vertex), vertices.end());
  for (const ObjCorner& corner : corners) {
    const auto found = std::lower_bound(vertices.begin(), vertices.end(), corner, comes_before);
    result.corner_vertices.push_back(static_cast<std::uint32_t>(found - vertices.begin()));
  }
}

std::vector<ObjCorner> corners_of(const ObjFile& file, const ObjPart& part) {
  std::vector<ObjCorner> corners;
  for (const std::uint32_t f : part.faces) {
    const auto first = file.corners.begin() + file.faces[f].first;
    corners.insert(corners.end(), first, first + file.faces[f].count);
  }
  return corners;
}

void cut_faces(const ObjFile& file, const ObjPart& part, ObjMesh& result) {
  std::vector<glm::vec3> polygon;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  const std::uint32_t* vertex = result.corner_vertices.data();
  for (const std::uint32_t f : part.faces) {
    const ObjFace& face = file.faces[f];
    polygon.clear();
    triangles.clear();
    for (std::uint32_t c = 0; c < face.count; ++c)
      polygon.push_back(file.positions[file.corners[face.first + c].position]);
    if (!triangulate_polygon(polygon, triangles))
      throw Error(ErrorKind::bad_input, fmt::format("{}:{}", file.path, face.line),
                  fmt::format("this face of {} corners is not convex; at most {} corners are cut into triangles",
                              face.count, max_ear_clipping_corners));
    for (const auto& [a, b, c] : triangles) result.mesh.triangles.emplace_back(vertex[a], vertex[b], vertex[c]);
    vertex += face.count;
  }
}

// The polygons' sides, each once by its positions: along a crease two vertices stand in one place.
std::vector<glm::uvec2> polygon_sides(const ObjFile& file, const ObjPart& part, const ObjMesh& result) {
  struct Side {
    std::uint32_t low, high;  // positions
    glm::uvec2 vertices;
    bool operator<(const Side& other) const {
      return std::tie(low, high, vertices.x, vertices.y) <
             std::tie(other.low, other.high, other.vertices.x, other.vertices.y);
    }
  };
  std::vector<Side> sides;
  sides.reserve(result.corner_vertices.size());
  const std::uint32_t* vertex = result.corner_vertices.data();
  for (const std::uint32_t f : part.faces) {
    const ObjFace& face = file.faces[f];
    for (std::uint32_t c = 0; c < face.count; ++c) {
      std::uint32_t a = c, b = (c + 1) % face.count;
      if (file.corners[face.first + a].position > file.corners[face.first + b].position) std::swap(a, b);
      sides.push_back(
          {file.corners[face.first + a].position, file.corners[face.first + b].position, {vertex[a], vertex[b]}});
    }
    vertex += face.count;
  }
  std::sort(sides.begin(), sides.end());
  std::vector<glm::uvec2> edges;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const bool first = i == 0 || sides[i].low != sides[i - 1].low || sides[i].high != sides[i - 1].high;
    if (first && sides[i].low != sides[i].high) edges.push_back(sides[i].vertices);
  }
  return edges;
}

}  // namespace

std::vector<ObjPart> split_by_material(const ObjFile& file, ImportBudget& budget) {
  budget.charge(file.faces.size(), sizeof(std::uint32_t), file.path);
  budget.charge(file.materials.size() + 1, sizeof(ObjPart) + sizeof(std::size_t), file.path);
  std::vector<ObjPart> parts;
  constexpr std::size_t none = static_cast<std::size_t>(-1);
  std::vector<std::size_t> part_of(file.materials.size() + 1, none);  // of material -1 first
  for (std::size_t f = 0; f < file.faces.size(); ++f) {
    const std::int32_t material = file.faces[f].material;
    std::size_t& part = part_of[static_cast<std::size_t>(material + 1)];
    if (part == none) {
      part = parts.size();
      parts.push_back({material, {}});
    }
    parts[part].faces.push_back(static_cast<std::uint32_t>(f));
  }
  return parts;
}

void check_topology(const ObjFile& file, const ObjFile& neutral) {
  if (file.positions.size() != neutral.positions.size())
    throw Error(ErrorKind::bad_input, file.path,
                fmt::format("has {} vertices (v), but {} has {}; a morph target has as many", file.positions.size(),
                            neutral.path, neutral.positions.size()));
  if (file.faces.empty()) return;  // positions alone
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

ObjMesh make_mesh(const ObjFile& file, const ObjPart& part, ImportBudget& budget) {
  ObjMesh result;
  const std::vector<ObjCorner> corners = corners_of(file, part);
  budget.charge(corners.size(), 2 * sizeof(ObjCorner) + sizeof(std::uint32_t), file.path);
  number_vertices(corners, result);

  Mesh& mesh = result.mesh;
  const bool with_normals = !file.normals.empty(), with_uvs = !file.uvs.empty();
  budget.charge(result.vertices.size(), 2 * sizeof(glm::vec3) + sizeof(glm::vec4) + sizeof(glm::vec2), file.path);
  for (const ObjCorner& vertex : result.vertices) {
    mesh.positions.push_back(file.positions[vertex.position]);
    if (with_normals) mesh.normals.push_back(stored_normal(file.normals[static_cast<std::size_t>(vertex.normal)]));
    if (!file.colors.empty()) mesh.colors.emplace_back(file.colors[vertex.position], 1.0f);
    if (with_uvs) mesh.uvs.push_back(vertex.uv < 0 ? glm::vec2(0) : file.uvs[static_cast<std::size_t>(vertex.uv)]);
  }
  cut_faces(file, part, result);
  const auto is_triangle = [&](std::uint32_t face) { return file.faces[face].count == 3; };
  if (with_normals || with_uvs || !std::all_of(part.faces.begin(), part.faces.end(), is_triangle))
    mesh.edges = polygon_sides(file, part, result);
  return result;
}

MorphTarget make_target(const ObjFile& file, const ObjPart& part, const ObjMesh& neutral, ImportBudget& budget) {
  budget.charge(neutral.vertices.size(), 2 * sizeof(glm::vec3) + sizeof(glm::dvec3), file.path);
  MorphTarget target;
  target.form = TargetForm::absolute;
  for (const ObjCorner& vertex : neutral.vertices) target.positions.push_back(file.positions[vertex.position]);
  if (neutral.mesh.normals.empty() || file.normals.empty()) return target;

  // Vertices that differ in their texture coordinates alone have one normal.
  std::vector<std::size_t> first(neutral.vertices.size());
  for (std::size_t v = 1; v < first.size(); ++v) {
    const ObjCorner &a = neutral.vertices[v - 1], &b = neutral.vertices[v];
    first[v] = a.position == b.position && a.normal == b.normal ? first[v - 1] : v;
  }
  std::vector<glm::dvec3> sums(neutral.vertices.size());
  const std::vector<ObjCorner> corners = corners_of(file, part);
  for (std::size_t c = 0; c < corners.size(); ++c)
    sums[first[neutral.corner_vertices[c]]] += unit(file.normals[static_cast<std::size_t>(corners[c].normal)]);
  for (const std::size_t v : first) target.normals.push_back(stored_normal(sums[v]));
  return target;
}

}  // namespace morphcl
