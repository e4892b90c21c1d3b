// The indices of a primitive's mode as a list of triangles or of line segments.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace morphcl {

// The numbers are those of the file format.
enum class GltfMode { points, lines, line_loop, line_strip, triangles, triangle_strip, triangle_fan };

struct GltfTopology {
  std::vector<glm::uvec3> triangles;
  std::vector<glm::uvec2> edges;  // of the line modes
};

// Indices that make no whole triangle or line at the end are left out, as the specification asks. Points give nothing.
GltfTopology gltf_topology(GltfMode mode, const std::vector<std::uint32_t>& indices);

}  // namespace morphcl
