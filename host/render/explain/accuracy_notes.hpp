// What a plan says about the accuracy of vertices.
#pragma once

#include "host/render/explain/cost_model.hpp"
#include "host/render/frame/frame_plan.hpp"
#include "morphcl/explain.hpp"

namespace morphcl {

// One note for each of the first few draws, and one for the rest: the form of its vertices, how far off they may be,
// and why no cheaper form was chosen. Nothing for scenes that state no error.
std::vector<PlanNote> accuracy_notes(const Scene& scene, const FramePlan& plan, const CostModel& model = {});

}  // namespace morphcl
