#include "host/scene/gltf/gltf_topology.hpp"

namespace morphcl {

GltfTopology gltf_topology(GltfMode mode, const std::vector<std::uint32_t>& indices) {
  GltfTopology topology;
  auto& [triangles, edges] = topology;
  const std::size_t count = indices.size();
  switch (mode) {
    case GltfMode::points:
      break;
    case GltfMode::lines:
      for (std::size_t i = 0; i + 1 < count; i += 2) edges.emplace_back(indices[i], indices[i + 1]);
      break;
    case GltfMode::line_loop:
    case GltfMode::line_strip:
      for (std::size_t i = 0; i + 1 < count; ++i) edges.emplace_back(indices[i], indices[i + 1]);
      if (mode == GltfMode::line_loop && count > 1) edges.emplace_back(indices[count - 1], indices[0]);
      break;
    case GltfMode::triangles:
      for (std::size_t i = 0; i + 2 < count; i += 3) triangles.emplace_back(indices[i], indices[i + 1], indices[i + 2]);
      break;
    case GltfMode::triangle_strip:  // every other triangle swaps two corners, so that all wind alike
      for (std::size_t i = 0; i + 2 < count; ++i)
        triangles.emplace_back(indices[i], indices[i + 1 + i % 2], indices[i + 2 - i % 2]);
      break;
    case GltfMode::triangle_fan:
      for (std::size_t i = 0; i + 2 < count; ++i) triangles.emplace_back(indices[i + 1], indices[i + 2], indices[0]);
      break;
  }
  return topology;
}

}  // namespace morphcl
