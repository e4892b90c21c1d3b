// The reference's view of areas_at() in kernels/shade.h.
#pragma once

#include <algorithm>
#include <cmath>

#include "host/render/frame/scene_vertices.hpp"
#include "host/render/reference/light.hpp"

namespace morphcl::reference {

// Doubled areas opposite to the corners, square corner units; all have the sign of the orientation on the screen, or
// are 0, where the place is in the triangle.
struct Areas {
  float corner[3];
  float min() const { return std::min(corner[0], std::min(corner[1], corner[2])); }
  float max() const { return std::max(corner[0], std::max(corner[1], corner[2])); }
  bool inside() const { return min() >= 0.0f || max() <= 0.0f; }
};

// Those of the wrong sign become next to nothing: a place that coverage's grid has in the triangle may lie outside its
// corners.
inline Areas within_triangle(const Draw& draw, const Areas& areas) {
  constexpr float min_area = 0x1p-40f;
  bool negative = !draw.mirrored;  // of front faces
  if (draw.double_sided || draw.shading == Shading::wireframe)
    negative = areas.corner[0] + areas.corner[1] + areas.corner[2] < 0.0f;
  Areas within;
  for (int i = 0; i < 3; ++i)
    within.corner[i] = negative ? std::min(areas.corner[i], -min_area) : std::max(areas.corner[i], min_area);
  return within;
}

// At a place in sub-pixels.
inline Areas areas_at(const ScreenVertex corner[3], int px, int py) {
  float dx[3], dy[3];
  for (int i = 0; i < 3; ++i) {
    dx[i] = static_cast<float>(corner[i].corner_x() - std::int64_t{px} * layout::corner_units);
    dy[i] = static_cast<float>(corner[i].corner_y() - std::int64_t{py} * layout::corner_units);
  }
  Areas areas;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    areas.corner[i] = difference_of_products(dx[j], dy[k], dx[k], dy[j]);
  }
  return areas;
}

}  // namespace morphcl::reference
