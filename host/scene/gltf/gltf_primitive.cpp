#include "host/scene/gltf/gltf_primitive.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "host/scene/gltf/gltf_attributes.hpp"
#include "host/scene/gltf/gltf_material.hpp"
#include "host/scene/gltf/gltf_topology.hpp"
#include "morphcl/error.hpp"

namespace morphcl {

namespace {

// Quantised normals are off by their step. They decide how the faces are lit and no more, so where one has no direction
// all are dropped.
void normalize(std::vector<glm::vec3>& normals, const std::string& place, GltfWarnings& warnings) {
  std::size_t wrong = 0;
  for (glm::vec3& normal : normals) {
    const glm::dvec3 exact(normal);
    const double length = glm::length(exact);
    if (length > 0 && std::isfinite(length))
      normal = glm::vec3(exact / length);
    else
      ++wrong;
  }
  if (wrong == 0) return;
  warnings.say(fmt::format("{}: {} of {} normals are zero or no numbers, so the faces are lit flat", place, wrong,
                           normals.size()));
  normals.clear();
}

// From 0 to 1; those that are no numbers have the colour of no vertex colour.
void mend_colors(std::vector<glm::vec4>& colors, const std::string& place, GltfWarnings& warnings) {
  std::size_t clamped = 0, unknown = 0;
  for (glm::vec4& color : colors) {
    if (std::isnan(color.r) || std::isnan(color.g) || std::isnan(color.b) || std::isnan(color.a)) {
      color = glm::vec4(1.0f);
      ++unknown;
    }
    const glm::vec4 inside = glm::clamp(color, 0.0f, 1.0f);
    if (inside != color) ++clamped;
    color = inside;
  }
  if (clamped > 0)
    warnings.say(
        fmt::format("{}: {} of {} vertex colours are not from 0 to 1 and are clamped", place, clamped, colors.size()));
  if (unknown > 0)
    warnings.say(
        fmt::format("{}: {} of {} vertex colours are no numbers; white is used", place, unknown, colors.size()));
}

// They are seen in the channel uv alone, so what is wrong with them costs the coordinates, not the model.
std::vector<glm::vec2> read_uvs(const GltfAttributes& reader, const GltfValue& attributes, std::size_t vertex_count,
                                GltfWarnings& warnings) {
  try {
    const int accessor = reader.find(attributes, "TEXCOORD_0");
    return accessor < 0 ? std::vector<glm::vec2>() : reader.read_uv(accessor, vertex_count);
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::bad_input) throw;
    warnings.say(fmt::format("{}; the mesh has no texture coordinates then", error.what()));
    return {};
  }
}

template <typename Vector>
void drop_unless_finite(std::vector<Vector>& moves, const std::string& place, const char* what,
                        GltfWarnings& warnings) {
  for (const Vector& move : moves)
    for (int c = 0; c < Vector::length(); ++c)
      if (!std::isfinite(move[c])) {
        warnings.say(fmt::format("{}: holds numbers that are not finite, so the target does not move {}", place, what));
        moves.clear();
        return;
      }
}

MorphTarget read_target(const GltfAttributes& reader, const GltfValue& json, const GltfValue& attributes,
                        std::size_t vertex_count, bool has_alpha, GltfWarnings& warnings) {
  const auto accessor_of = [&](const char* name) {
    const int accessor = reader.find(json, name);
    if (accessor >= 0 && !attributes.find(name)) json.fail(fmt::format("moves {}, which the primitive has not", name));
    return accessor;
  };
  MorphTarget target;
  target.form = TargetForm::delta;
  if (const int accessor = accessor_of("POSITION"); accessor >= 0)
    target.positions = reader.read_vec3(accessor, GltfAttribute::position, vertex_count);
  if (const int accessor = accessor_of("NORMAL"); accessor >= 0) {
    target.normals = reader.read_vec3(accessor, GltfAttribute::normal, vertex_count);
    drop_unless_finite(target.normals, reader.place(accessor), "normals", warnings);
  }
  if (const int accessor = accessor_of("COLOR_0"); accessor >= 0) {
    target.colors = reader.read_color(accessor, vertex_count, 0.0f);
    drop_unless_finite(target.colors, reader.place(accessor), "colours", warnings);
    if (!has_alpha)
      for (glm::vec4& color : target.colors) color.a = 0.0f;
  }
  return target;
}

}  // namespace

std::optional<GltfPrimitive> read_primitive(const GltfDocument& document, const GltfAccessors& accessors,
                                            const GltfValue& json, const std::vector<std::string>& target_names,
                                            bool decode, GltfWarnings& warnings) {
  const GltfAttributes reader(document, accessors, json, decode);
  const std::uint64_t mode = json.integer("mode", 4);
  if (mode > 6) json.get("mode").fail(fmt::format("is {}; modes are 0 to 6", mode));
  const GltfMaterial material =
      read_material(document, json.index("material", document.count("materials"), "materials"), warnings);
  const GltfValue attributes = json.get("attributes");
  const int position = reader.find(attributes, "POSITION");
  if (position < 0) {
    warnings.not_drawn("primitives without POSITION");
    return std::nullopt;
  }

  GltfPrimitive result;
  result.material = material.material;
  Mesh& mesh = result.mesh;
  const std::size_t vertex_count = accessors.count(position);
  mesh.positions = reader.read_vec3(position, GltfAttribute::position, vertex_count);
  if (const int accessor = reader.find(attributes, "NORMAL"); accessor >= 0) {
    mesh.normals = reader.read_vec3(accessor, GltfAttribute::normal, vertex_count);
    normalize(mesh.normals, accessors.place(accessor), warnings);
  }
  if (const int accessor = reader.find(attributes, "COLOR_0"); accessor >= 0) {
    mesh.colors = reader.read_color(accessor, vertex_count, 1.0f);
    mend_colors(mesh.colors, accessors.place(accessor), warnings);
    if (!material.has_alpha)
      for (glm::vec4& color : mesh.colors) color.a = 1.0f;
  }
  mesh.uvs = read_uvs(reader, attributes, vertex_count, warnings);
  if (const auto targets = json.find("targets"))
    for (std::size_t i = 0; i < targets->size(); ++i) {
      document.budget().charge(1, sizeof(MorphTarget) + target_names[i].size(), json.place());
      mesh.targets.push_back(
          read_target(reader, (*targets)[i], attributes, vertex_count, material.has_alpha, warnings));
      mesh.targets.back().name = target_names[i];
    }

  const std::vector<std::uint32_t> indices = reader.read_indices(vertex_count);
  if (!decode) return std::nullopt;
  document.budget().charge(indices.size(), sizeof(glm::uvec3), json.place());
  GltfTopology topology = gltf_topology(static_cast<GltfMode>(mode), indices);
  mesh.triangles = std::move(topology.triangles);
  mesh.edges = std::move(topology.edges);
  if (mesh.triangles.empty() && mesh.edges.empty()) {
    warnings.not_drawn(mode == 0 ? "points" : "primitives without a whole triangle or line");
    return std::nullopt;
  }
  if (!material.seen) return std::nullopt;
  if (mesh.normals.empty())
    for (MorphTarget& target : mesh.targets) target.normals.clear();
  if (mesh.triangles.empty()) result.material.shading = Shading::wireframe;
  return result;
}

}  // namespace morphcl
