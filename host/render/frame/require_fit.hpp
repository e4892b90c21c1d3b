// What a frame buffer must be for a plan to be drawn into it.
#pragma once

#include "host/image/frame_buffer.hpp"
#include "host/render/frame/frame_plan.hpp"

namespace morphcl {

// Error(usage) that names both when `frame` has another size than the plan or other channels, be they too few or too
// many. Every renderer asks this before it writes.
void require_fit(const FramePlan& plan, const FrameBuffer& frame);

}  // namespace morphcl
