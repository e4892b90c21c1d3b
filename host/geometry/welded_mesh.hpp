// A mesh as a body: vertices that are copies of one point, made for normals or seams, are one.
#pragma once

#include <cstdint>
#include <vector>

#include "morphcl/mesh.hpp"

namespace morphcl {

struct WeldedMesh {
  std::vector<std::uint32_t> point_of_vertex;
  std::vector<std::uint32_t> vertex_of_point;  // the first of each point's vertices
  std::vector<glm::uvec2> edges;               // between points, each once, the smaller first, sorted
};

// Vertices are one point where they have the same position in the base and in every target. Edges are those of the
// triangles, or what wireframe draws where there are none. O(n log n).
WeldedMesh weld(const Mesh& mesh);

}  // namespace morphcl
