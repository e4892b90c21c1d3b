// Triangles of a rectangular grid of vertices, shared by the built-in solids.
#pragma once

#include <vector>

#include "morphcl/solids.hpp"

namespace morphcl {

// Which triangles of the first and the last row are left out because one of their edges is a single point.
struct CollapsedRows {
  bool first = false, last = false;
};

// Appends the triangles of a grid of (u+1) x (v+1) vertices that starts at `first_vertex`, row by row: vertex (i, j) is
// first_vertex + j (u+1) + i. With a = (i, j), b = (i+1, j), c = (i, j+1), d = (i+1, j+1) each quad is a, c, b and
// b, c, d: counter-clockwise seen from the side where i runs to the right and j downwards. `flipped` turns them over.
void append_grid_triangles(Segments segments, glm::uint first_vertex, CollapsedRows collapsed, bool flipped,
                           std::vector<glm::uvec3>& triangles);

}  // namespace morphcl
