// How much memory a frame needs, from its plan alone: linear in vertices, primitives and pixels.
#pragma once

#include <cstddef>
#include <string>

#include "host/render/plan/planner.hpp"

namespace morphcl {

struct MemoryNeed {
  std::size_t meshes = 0;          // device: vertices, targets and indices of the meshes that are drawn
  std::size_t vertices = 0;        // device: what vertices and faces become in this frame
  std::size_t bins = 0;            // device: which primitives touch which tiles, as guessed before the first frame
  std::size_t pixels = 0;          // host, which CPU devices write to directly
  std::size_t largest_buffer = 0;  // of the device's, which it allocates in one piece
  const char* largest_name = "";

  std::size_t device() const { return meshes + vertices + bins; }
};

MemoryNeed estimate_memory(const FramePlan& plan);

// "" where every buffer fits into what the device allocates at once; else which does not, with the numbers.
std::string exceeded_limit(const MemoryNeed& need, std::size_t max_allocation);

}  // namespace morphcl
