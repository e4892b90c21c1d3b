// The reference's view of kernels/precise_vertices.h: vertices of draws that are not plain.
#pragma once

#include "host/render/frame/scene_vertices.hpp"

namespace morphcl::reference {

// The morphed position relative to the draw's pivot.
glm::vec3 pivot_position(const Draw& draw, std::size_t vertex);

// Position and clip coordinates in two floats, rounded once.
void set_two_float_clip_point(const Draw& draw, std::size_t index, Vertex& vertex);

}  // namespace morphcl::reference
