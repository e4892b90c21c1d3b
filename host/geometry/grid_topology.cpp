#include "host/geometry/grid_topology.hpp"

namespace morphcl {

void append_grid_triangles(Segments segments, glm::uint first_vertex, CollapsedRows collapsed, bool flipped,
                           std::vector<glm::uvec3>& triangles) {
  const auto append = [&](glm::uint a, glm::uint b, glm::uint c) {
    triangles.push_back(flipped ? glm::uvec3(a, c, b) : glm::uvec3(a, b, c));
  };
  const auto columns = static_cast<glm::uint>(segments.u), rows = static_cast<glm::uint>(segments.v);
  for (glm::uint j = 0; j < rows; ++j)
    for (glm::uint i = 0; i < columns; ++i) {
      const glm::uint a = first_vertex + j * (columns + 1) + i, b = a + 1, c = a + columns + 1, d = c + 1;
      if (!(collapsed.first && j == 0)) append(a, c, b);
      if (!(collapsed.last && j + 1 == rows)) append(b, c, d);
    }
}

}  // namespace morphcl
