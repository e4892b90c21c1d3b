// The reference's view of kernels/shade.h: the colour of one pixel.
#pragma once

#include <glm/glm.hpp>

#include "host/render/reference/visibility.hpp"

namespace morphcl::reference {

// Positive distance along the view axis.
float eye_distance(const FramePlan& plan, float depth);

glm::vec3 shade(const FramePlan& plan, const Visibility& visible, const std::vector<std::vector<Vertex>>& vertices,
                int x, int y);

}  // namespace morphcl::reference
