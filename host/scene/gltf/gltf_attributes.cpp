#include "host/scene/gltf/gltf_attributes.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numeric>

namespace morphcl {

void GltfAttributes::check_type(int accessor, GltfAttribute attribute, std::size_t vertex_count) const {
  if (accessors_.count(accessor) != vertex_count)
    accessors_.fail(accessor, fmt::format("has {} elements, but {} has {} vertices", accessors_.count(accessor),
                                          primitive_.path(), vertex_count));
  const std::string& type = accessors_.type(accessor);
  const bool is_color = attribute == GltfAttribute::color, is_uv = attribute == GltfAttribute::uv;
  if (type != (is_uv ? "VEC2" : "VEC3") && !(type == "VEC4" && is_color))
    accessors_.fail(accessor, fmt::format("is {}; {} is needed here", type,
                                          is_uv      ? "VEC2"
                                          : is_color ? "VEC3 or VEC4"
                                                     : "VEC3"));
  const GltfComponent component = accessors_.component(accessor);
  if (component == GltfComponent::float32) return;
  const bool normalized = accessors_.normalized(accessor);
  const bool quantization = document_.uses_extension("KHR_mesh_quantization");
  bool allowed = component != GltfComponent::uint32;
  if (attribute == GltfAttribute::position) allowed = allowed && quantization;
  if (attribute == GltfAttribute::normal) allowed = allowed && quantization && normalized;
  if (is_color) allowed = allowed && normalized;
  const bool is_unsigned = component == GltfComponent::uint8 || component == GltfComponent::uint16;
  if (is_uv) allowed = allowed && (quantization || (normalized && is_unsigned));
  if (!allowed)
    accessors_.fail(accessor, is_color ? "colours must be float or normalized integers of 8 or 16 bits"
                              : is_uv  ? "texture coordinates must be float or normalized unsigned integers of 8 or 16 "
                                         "bits"
                                      : "must be float, or integers of 8 or 16 bits (normalized for normals) in a file "
                                        "that uses KHR_mesh_quantization");
}

std::vector<glm::vec3> GltfAttributes::read_vec3(int accessor, GltfAttribute attribute,
                                                 std::size_t vertex_count) const {
  check_type(accessor, attribute, vertex_count);
  if (!decode_) return {};
  const auto numbers =
      attribute == GltfAttribute::position ? GltfAccessors::Numbers::finite : GltfAccessors::Numbers::any;
  const std::vector<float> components = accessors_.decode<float>(accessor, numbers);
  document_.budget().charge(vertex_count, sizeof(glm::vec3), primitive_.place());
  std::vector<glm::vec3> values(vertex_count);
  for (std::size_t i = 0; i < vertex_count; ++i)
    values[i] = {components[3 * i], components[3 * i + 1], components[3 * i + 2]};
  return values;
}

std::vector<glm::vec4> GltfAttributes::read_color(int accessor, std::size_t vertex_count, float alpha_of_rgb) const {
  check_type(accessor, GltfAttribute::color, vertex_count);
  if (!decode_) return {};
  const std::vector<float> components = accessors_.decode<float>(accessor, GltfAccessors::Numbers::any);
  document_.budget().charge(vertex_count, sizeof(glm::vec4), primitive_.place());
  std::vector<glm::vec4> values(vertex_count);
  const bool rgba = accessors_.type(accessor) == "VEC4";
  for (std::size_t i = 0; i < vertex_count; ++i) {
    const float* c = &components[(rgba ? 4 : 3) * i];
    values[i] = {c[0], c[1], c[2], rgba ? c[3] : alpha_of_rgb};
  }
  return values;
}

std::vector<glm::vec2> GltfAttributes::read_uv(int accessor, std::size_t vertex_count) const {
  check_type(accessor, GltfAttribute::uv, vertex_count);
  if (!decode_) return {};
  const std::vector<float> components = accessors_.decode<float>(accessor, GltfAccessors::Numbers::any);
  document_.budget().charge(vertex_count, sizeof(glm::vec2), primitive_.place());
  std::vector<glm::vec2> values(vertex_count);
  for (std::size_t i = 0; i < vertex_count; ++i) {
    const float u = components[2 * i], v = 1 - components[2 * i + 1];
    values[i] = {std::isfinite(u) ? u : 0.0f, std::isfinite(v) ? v : 0.0f};
  }
  return values;
}

std::vector<std::uint32_t> GltfAttributes::read_indices(std::size_t vertex_count) const {
  const int accessor = primitive_.index("indices", accessors_.size(), "accessors");
  if (accessor >= 0) {
    const GltfComponent component = accessors_.component(accessor);
    if (accessors_.type(accessor) != "SCALAR" ||
        (component != GltfComponent::uint8 && component != GltfComponent::uint16 && component != GltfComponent::uint32))
      accessors_.fail(accessor, "must be SCALAR of unsigned integers (5121, 5123 or 5125) to be indices");
  }
  if (!decode_) return {};
  if (accessor < 0) {
    document_.budget().charge(vertex_count, sizeof(std::uint32_t), primitive_.place());
    std::vector<std::uint32_t> indices(vertex_count);
    std::iota(indices.begin(), indices.end(), 0u);
    return indices;
  }
  std::vector<std::uint32_t> indices = accessors_.decode<std::uint32_t>(accessor);
  for (std::size_t i = 0; i < indices.size(); ++i)
    if (indices[i] >= vertex_count)
      accessors_.fail(accessor, fmt::format("index {} is {}, but {} has {} vertices", i, indices[i], primitive_.path(),
                                            vertex_count));
  return indices;
}

}  // namespace morphcl
