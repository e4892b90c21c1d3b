// The reference's view of areas_at() in kernels/shade.h.
#pragma once

#include <algorithm>

#include "host/render/frame/scene_vertices.hpp"
#include "host/render/reference/light.hpp"

namespace morphcl::reference {

// Doubled areas opposite to the corners; all have the sign of the orientation on the screen, or are 0, where the place
// is in the triangle.
struct Areas {
  float corner[3];
  float min() const { return std::min(corner[0], std::min(corner[1], corner[2])); }
  float max() const { return std::max(corner[0], std::max(corner[1], corner[2])); }
  bool inside() const { return min() >= 0.0f || max() <= 0.0f; }
};

// At a place in sub-pixels.
inline Areas areas_at(const ScreenVertex corner[3], int px, int py) {
  float dx[3], dy[3];
  for (int i = 0; i < 3; ++i) {
    dx[i] = static_cast<float>(corner[i].x - px);
    dy[i] = static_cast<float>(corner[i].y - py);
  }
  Areas areas;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    areas.corner[i] = difference_of_products(dx[j], dy[k], dx[k], dy[j]);
  }
  return areas;
}

}  // namespace morphcl::reference
