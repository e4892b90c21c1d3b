// The reference renderer's pixels before they are stored: which primitive each shows, and its colour and distance in
// fp32. For measurements; frames are drawn by ReferenceRenderer.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "host/render/frame/frame_plan.hpp"

namespace morphcl::reference {

struct ShownPixel {
  std::uint32_t object, primitive;  // of the scene; a triangle, or an edge of a wireframe. nothing_shown: background
  float distance;                   // along the view axis
  glm::vec3 color;                  // 0 0 0 when the plan has no colour
};
constexpr std::uint32_t nothing_shown = 0xffffffff;

// One a pixel, row by row from the top. Of plans that blend: what is opaque.
std::vector<ShownPixel> shown_pixels(const FramePlan& plan);

}  // namespace morphcl::reference
