// A plan in words: what a frame needs, what is left out and why, what each part costs, and the memory it takes.
//
// Made only where somebody reads it: rendering does not pay for it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "morphcl/planner.hpp"

#pragma GCC visibility push(default)
namespace morphcl {

struct PlanNote {
  std::string item;         // "vertex normals"
  bool done;                // false: left out
  std::string reason;       // "no lights in the scene"
  double milliseconds = 0;  // what it costs, or what leaving it out saves: an estimate for 2 cores with PoCL 3.1
};

struct MemoryNeed {                // bytes
  std::size_t meshes = 0;          // device: vertices, targets and indices of the meshes that are drawn
  std::size_t vertices = 0;        // device: what vertices and faces become in this frame
  std::size_t bins = 0;            // device: which primitives touch which tiles, as guessed before the first frame
  std::size_t pixels = 0;          // host, which CPU devices write to directly
  std::size_t largest_buffer = 0;  // of the device's, which it allocates in one piece
  const char* largest_name = "";

  std::size_t device() const { return meshes + vertices + bins; }
};

struct PlanReport {
  Plan plan;
  std::vector<PlanNote> notes;
  double milliseconds = 0;  // estimate for the whole frame, drawn alone; notes overlap and need not add up to it
  MemoryNeed memory;
};

// An equal picture is looked for among the 1,000 frames of scene.frames before this one, no further. Errors as
// Planner::plan() has them for this frame.
PlanReport explain(const Planner& planner, std::int64_t frame);

// "" where every buffer fits into what the device allocates at once (DeviceInfo::max_allocation); else which does not,
// with the numbers.
std::string exceeded_limit(const MemoryNeed& need, std::size_t max_allocation);

}  // namespace morphcl
#pragma GCC visibility pop
