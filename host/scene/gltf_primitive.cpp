#include "host/scene/gltf_primitive.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "host/scene/gltf_material.hpp"
#include "host/scene/gltf_topology.hpp"

namespace morphcl {

namespace {

enum class Attribute { position, normal, color };

class PrimitiveReader {
 public:
  PrimitiveReader(const GltfDocument& document, const GltfAccessors& accessors, const GltfValue& json)
      : document_(document), accessors_(accessors), json_(json) {}

  // The accessor of an attribute; -1 when the object has none.
  int find(const GltfValue& attributes, const char* name) const {
    return attributes.index(name, accessors_.size(), "accessors");
  }

  std::vector<glm::vec3> read_vec3(int accessor, Attribute attribute, std::size_t count) const {
    check_type(accessor, attribute, count);
    if (accessors_.type(accessor) != "VEC3") accessors_.fail(accessor, "must be VEC3 here");
    const std::vector<float> components = accessors_.decode<float>(accessor);
    document_.budget().charge(count, sizeof(glm::vec3), json_.place());
    std::vector<glm::vec3> values(count);
    for (std::size_t i = 0; i < count; ++i)
      values[i] = {components[3 * i], components[3 * i + 1], components[3 * i + 2]};
    return values;
  }

  std::vector<glm::vec4> read_color(int accessor, std::size_t count, float alpha_of_rgb) const {
    check_type(accessor, Attribute::color, count);
    const bool rgba = accessors_.type(accessor) == "VEC4";
    if (!rgba && accessors_.type(accessor) != "VEC3") accessors_.fail(accessor, "must be VEC3 or VEC4 here");
    const std::vector<float> components = accessors_.decode<float>(accessor);
    document_.budget().charge(count, sizeof(glm::vec4), json_.place());
    std::vector<glm::vec4> values(count);
    const std::size_t width = rgba ? 4 : 3;
    for (std::size_t i = 0; i < count; ++i) {
      const float* c = &components[width * i];
      values[i] = {c[0], c[1], c[2], rgba ? c[3] : alpha_of_rgb};
    }
    return values;
  }

  std::vector<std::uint32_t> read_indices(std::size_t vertex_count) const {
    const int accessor = json_.index("indices", accessors_.size(), "accessors");
    if (accessor < 0) {
      document_.budget().charge(vertex_count, sizeof(std::uint32_t), json_.place());
      std::vector<std::uint32_t> indices(vertex_count);
      std::iota(indices.begin(), indices.end(), 0u);
      return indices;
    }
    const GltfComponent component = accessors_.component(accessor);
    if (accessors_.type(accessor) != "SCALAR" ||
        (component != GltfComponent::uint8 && component != GltfComponent::uint16 && component != GltfComponent::uint32))
      accessors_.fail(accessor, "must be SCALAR of unsigned integers (5121, 5123 or 5125) to be indices");
    std::vector<std::uint32_t> indices = accessors_.decode<std::uint32_t>(accessor);
    for (std::size_t i = 0; i < indices.size(); ++i)
      if (indices[i] >= vertex_count)
        accessors_.fail(accessor, fmt::format("index {} is {}, but {} has {} vertices", i, indices[i], json_.place(),
                                              vertex_count));
    return indices;
  }

 private:
  // Component types by the specification, and those of KHR_mesh_quantization where the file declares it.
  void check_type(int accessor, Attribute attribute, std::size_t count) const {
    if (accessors_.count(accessor) != count)
      accessors_.fail(accessor, fmt::format("has {} elements, but {} has {} vertices", accessors_.count(accessor),
                                            json_.place(), count));
    const GltfComponent component = accessors_.component(accessor);
    if (component == GltfComponent::float32) return;
    const bool normalized = accessors_.normalized(accessor);
    const bool quantization = document_.uses_extension("KHR_mesh_quantization");
    bool allowed = component != GltfComponent::uint32;
    if (attribute == Attribute::position) allowed = allowed && quantization;
    if (attribute == Attribute::normal) allowed = allowed && quantization && normalized;
    if (attribute == Attribute::color) allowed = allowed && normalized;
    if (!allowed)
      accessors_.fail(accessor, attribute == Attribute::color
                                    ? "colours must be float or normalized integers of 8 or 16 bits"
                                    : "must be float, or integers of 8 or 16 bits (normalized for normals) in a file "
                                      "that uses KHR_mesh_quantization");
  }

  const GltfDocument& document_;
  const GltfAccessors& accessors_;
  const GltfValue& json_;
};

// Quantised normals are off by their step; a zero normal has no direction and is lit from the front.
void normalize(std::vector<glm::vec3>& normals) {
  for (glm::vec3& normal : normals) {
    const glm::dvec3 exact(normal);
    const double length = glm::length(exact);
    normal = length > 0 ? glm::vec3(exact / length) : glm::vec3(0, 0, 1);
  }
}

MorphTarget read_target(const PrimitiveReader& reader, const GltfValue& json, const GltfValue& attributes,
                        std::size_t vertex_count, bool blend) {
  const auto accessor_of = [&](const char* name) {
    const int accessor = reader.find(json, name);
    if (accessor >= 0 && !attributes.find(name)) json.fail(fmt::format("moves {}, which the primitive has not", name));
    return accessor;
  };
  MorphTarget target;
  target.form = TargetForm::delta;
  if (const int accessor = accessor_of("POSITION"); accessor >= 0)
    target.positions = reader.read_vec3(accessor, Attribute::position, vertex_count);
  if (const int accessor = accessor_of("NORMAL"); accessor >= 0)
    target.normals = reader.read_vec3(accessor, Attribute::normal, vertex_count);
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
                                            GltfWarnings& warnings) {
  const PrimitiveReader reader(document, accessors, json);
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
  mesh.positions = reader.read_vec3(position, Attribute::position, vertex_count);
  if (const int accessor = reader.find(attributes, "NORMAL"); accessor >= 0) {
    mesh.normals = reader.read_vec3(accessor, Attribute::normal, vertex_count);
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
