// What a frame takes, before one is measured. Within a factor of two where it was measured, for the shots of demos/.
#pragma once

#include "host/render/frame/frame_plan.hpp"

namespace morphcl {

// By the reference, on so many threads.
double estimated_reference_seconds(const FramePlan& plan, int threads);

// By the device on the same threads, where the reference takes `reference_seconds`.
double estimated_device_seconds(double reference_seconds);

}  // namespace morphcl
