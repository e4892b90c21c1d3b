#include "host/scene/gltf/gltf_primitive.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "host/scene/gltf/gltf_attributes.hpp"
#include "host/scene/gltf/gltf_material.hpp"
#include "host/scene/gltf/gltf_topology.hpp"

namespace morphcl {

namespace {

// Quantised normals are off by their step; a zero normal has no direction and is lit from the front.
void normalize(std::vector<glm::vec3>& normals) {
  for (glm::vec3& normal : normals) {
    const glm::dvec3 exact(normal);
    const double length = glm::length(exact);
    normal = length > 0 ? glm::vec3(exact / length) : glm::vec3(0, 0, 1);
  }
}

MorphTarget read_target(const GltfAttributes& reader, const GltfValue& json, const GltfValue& attributes,
                        std::size_t vertex_count, bool blend) {
  const auto accessor_of = [&](const char* name) {
    const int accessor = reader.find(json, name);
    if (accessor >= 0 && !attributes.find(name)) json.fail(fmt::format("moves {}, which the primitive has not", name));
    return accessor;
  };
  MorphTarget target;
  target.form = TargetForm::delta;
  if (const int accessor = accessor_of("POSITION"); accessor >= 0)
    target.positions = reader.read_vec3(accessor, GltfAttribute::position, vertex_count);
  if (const int accessor = accessor_of("NORMAL"); accessor >= 0)
    target.normals = reader.read_vec3(accessor, GltfAttribute::normal, vertex_count);
  if (const int accessor = accessor_of("COLOR_0"); accessor >= 0) {
    target.colors = reader.read_color(accessor, vertex_count, 0.0f);
    if (!blend)
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
    normalize(mesh.normals);
  }
  if (const int accessor = reader.find(attributes, "COLOR_0"); accessor >= 0) {
    mesh.colors = reader.read_color(accessor, vertex_count, 1.0f);
    for (glm::vec4& color : mesh.colors) {
      color = glm::clamp(color, 0.0f, 1.0f);
      if (!material.blend) color.a = 1.0f;
    }
  }
  if (const auto targets = json.find("targets"))
    for (std::size_t i = 0; i < targets->size(); ++i) {
      document.budget().charge(1, sizeof(MorphTarget) + target_names[i].size(), json.place());
      mesh.targets.push_back(read_target(reader, (*targets)[i], attributes, vertex_count, material.blend));
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
  if (mesh.triangles.empty())
    result.material.shading = Shading::wireframe;
  else if (mesh.normals.empty() && result.material.shading != Shading::unlit)
    result.material.shading = Shading::flat;
  return result;
}

}  // namespace morphcl
