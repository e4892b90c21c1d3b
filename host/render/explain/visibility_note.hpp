// What the plan says of a frame's hidden-surface method.
#pragma once

#include <optional>

#include "host/render/explain/workload.hpp"
#include "morphcl/explain.hpp"

namespace morphcl {

// Nothing for the z-buffer, which takes no step of its own.
std::optional<PlanNote> visibility_note(const FramePlan& plan, const Workload& work);

}  // namespace morphcl
