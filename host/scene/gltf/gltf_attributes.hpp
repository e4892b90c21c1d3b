// The attributes and indices of a glTF primitive: checked by the rules of the specification, then decoded.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "host/scene/gltf/gltf_accessor.hpp"

namespace morphcl {

enum class GltfAttribute { position, normal, color, uv };

class GltfAttributes {
 public:
  // Without `decode` everything is checked but its data, and what is read is empty. The arguments outlive this.
  GltfAttributes(const GltfDocument& document, const GltfAccessors& accessors, const GltfValue& primitive, bool decode)
      : document_(document), accessors_(accessors), primitive_(primitive), decode_(decode) {}

  // The accessor of an attribute; -1 when the object has none.
  int find(const GltfValue& attributes, const char* name) const {
    return attributes.index(name, accessors_.size(), "accessors");
  }

  // One element a vertex. Error(bad_input) for another count or type: float, or what KHR_mesh_quantization allows in a
  // file that declares it; colours and texture coordinates are float or normalized unsigned.
  std::vector<glm::vec3> read_vec3(int accessor, GltfAttribute attribute, std::size_t vertex_count) const;
  std::vector<glm::vec4> read_color(int accessor, std::size_t vertex_count, float alpha_of_rgb) const;
  // Texture coordinates with v up: 1 - v of the file's. What is no finite number is 0.
  std::vector<glm::vec2> read_uv(int accessor, std::size_t vertex_count) const;

  std::string place(int accessor) const { return accessors_.place(accessor); }

  // All below vertex_count; 0, 1, 2, ... for a primitive without indices.
  std::vector<std::uint32_t> read_indices(std::size_t vertex_count) const;

 private:
  void check_type(int accessor, GltfAttribute attribute, std::size_t vertex_count) const;

  const GltfDocument& document_;
  const GltfAccessors& accessors_;
  const GltfValue& primitive_;
  bool decode_;
};

}  // namespace morphcl
