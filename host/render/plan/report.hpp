// A plan in words: what this frame needs, what is left out, and why.
//
// Made only where somebody reads it: rendering does not pay for it.
#pragma once

#include <string>
#include <vector>

#include "host/render/plan.hpp"

namespace morphcl {

struct PlanNote {
  std::string item;    // "vertex normals"
  bool done;           // false: left out
  std::string reason;  // "no lights in the scene"
};

struct PlanReport {
  FramePlan plan;
  std::vector<PlanNote> notes;
};

// `planner` plans `scene` with `options`. Errors as Planner::plan() has them.
PlanReport explain(const Planner& planner, const Scene& scene, const PlanOptions& options, std::int64_t frame);

}  // namespace morphcl
