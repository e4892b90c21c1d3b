// A plan in words: what this frame needs, what is left out and why, what each part costs, and the memory it takes.
//
// Made only where somebody reads it: rendering does not pay for it.
#pragma once

#include <string>
#include <vector>

#include "host/render/explain/memory_model.hpp"
#include "host/render/plan/planner.hpp"

namespace morphcl {

struct PlanNote {
  std::string item;         // "vertex normals"
  bool done;                // false: left out
  std::string reason;       // "no lights in the scene"
  double milliseconds = 0;  // estimate: what it costs, or what leaving it out saves
};

struct PlanReport {
  FramePlan plan;
  std::vector<PlanNote> notes;
  double milliseconds = 0;  // estimate for the whole frame, drawn alone; notes overlap and need not add up to it
  MemoryNeed memory;
};

// `planner` plans `scene` with `options`. Looks for an equal picture among at most 1,000 frames of the shot before this
// one. Errors as Planner::plan() has them for this frame.
PlanReport explain(const Planner& planner, const Scene& scene, const PlanOptions& options, std::int64_t frame);

}  // namespace morphcl
