// The reference's view of kernels/shade.h: the colour of one pixel, or of what a primitive shows of it.
#pragma once

#include <glm/glm.hpp>

#include "host/render/reference/visibility.hpp"

namespace morphcl::reference {

// Positive distance along the view axis.
float eye_distance(const FramePlan& plan, float depth);

glm::vec3 shade(const FramePlan& plan, const Visibility& visible, const std::vector<std::vector<Vertex>>& vertices,
                int x, int y);

// From a pixel's centre, sub-pixels.
struct SubPixelOffset {
  int x, y;
};

// Of a pixel with several samples: what `sample` shows, at the pixel's centre where that is in its triangle, else at
// `centroid`, the mean of the samples that show it.
glm::vec3 shade_part(const FramePlan& plan, const Visibility& visible, const Sample& sample,
                     const std::vector<std::vector<Vertex>>& vertices, int x, int y, SubPixelOffset centroid);

}  // namespace morphcl::reference
