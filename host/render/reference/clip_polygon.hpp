// The reference's view of kernels/clip_primitives.cl: one triangle or line at a time.
#pragma once

#include <vector>

#include "host/render/frame/scene_vertices.hpp"

namespace morphcl::reference {

struct Corner {
  ClipPoint clip;
  float weight[3];  // of the source primitive's vertices
};

// What is left of a closed polygon (or, with two corners, an open segment) in front of the near plane and inside the
// guard band.
std::vector<Corner> clip_polygon(std::vector<Corner> corners, const FramePlan& plan, const RasterGrid& grid);

}  // namespace morphcl::reference
