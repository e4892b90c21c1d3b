// How much memory a frame needs, from its plan alone: linear in vertices, primitives and pixels.
#pragma once

#include "host/render/frame/frame_plan.hpp"
#include "morphcl/explain.hpp"

namespace morphcl {

MemoryNeed estimate_memory(const FramePlan& plan);

}  // namespace morphcl
