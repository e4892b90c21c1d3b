// The situation before a job's first frame, told without opening a device.
#pragma once

#include "host/device/known_kernels.hpp"
#include "host/render/auto/choice.hpp"
#include "host/render/auto/frame_kernels.hpp"
#include "morphcl/renderer.hpp"

namespace morphcl {

// Those of `kernels` that the cache is not known to hold.
FrameKernels not_known(const FrameKernels& kernels, const KnownKernels& known);

// Sets what it takes to open the device and to compile what is not known.
void set_preparation(const FrameKernels& kernels, const KnownKernels& known, Situation& now);

// Of the first of `frames` frames that cost about what this one does. Error(usage) for the options' threads.
Situation first_situation(const FramePlan& plan, std::int64_t frames, const AutoOptions& options);

}  // namespace morphcl
