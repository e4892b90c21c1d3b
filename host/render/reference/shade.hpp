// The reference's view of kernels/shade.h: the colour of one pixel, or of what a primitive shows of it.
#pragma once

#include <glm/glm.hpp>
#include <optional>

#include "host/render/reference/pixel_part.hpp"
#include "host/render/reference/visibility.hpp"

namespace morphcl::reference {

// Positive distance along the view axis.
float eye_distance(const FramePlan& plan, float depth);

struct ShadedSurface {
  glm::vec3 color;  // not multiplied by alpha
  float alpha;      // 0 to 1; 1 of opaque draws
};

// What `sample` shows, at the pixel's centre, which is a sample.
ShadedSurface shade_centre(const FramePlan& plan, const Visibility& visible, const Sample& sample,
                           const std::vector<std::vector<Vertex>>& vertices, int x, int y);

// Of a pixel with several samples: what `sample` shows, at the pixel's centre where that is in its triangle, else at
// `centroid`, the mean of the samples that show it. Without one: at the mean of all samples that the triangle covers.
ShadedSurface shade_part(const FramePlan& plan, const Visibility& visible, const Sample& sample,
                         const std::vector<std::vector<Vertex>>& vertices, int x, int y,
                         std::optional<SubPixelOffset> centroid);

}  // namespace morphcl::reference
