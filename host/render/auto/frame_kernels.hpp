// The kernels that frames need, and small frames that have them compiled: a driver such as PoCL compiles a kernel when
// it is first started.
#pragma once

#include <set>
#include <vector>

#include "host/render/device/device_renderer.hpp"
#include "host/render/frame/frame_plan.hpp"

namespace morphcl {

using FrameKernels = std::set<FrameKernel>;

// Those that a device renderer starts for this plan and the plans after it, as far as the plan shows it: it may turn
// out that a later frame needs another one. (How launches are chosen: DeviceRenderer::prepare.)
FrameKernels frame_kernels(const FramePlan& plan);

// Compiling and storing, seconds: about, before anything is measured. Storing takes PoCL a time only where a binary has
// to be made (host/device/program_cache.hpp).
double compile_seconds(const FrameKernels& kernels);
double store_seconds(const FrameKernels& kernels);

// Plans of nothing to see that start all of `kernels`, of those in frame_kernels(), and of the others as few as there
// can be. They refer to meshes of this object.
class KernelSamples {
 public:
  explicit KernelSamples(const FrameKernels& kernels);
  KernelSamples(const KernelSamples&) = delete;
  KernelSamples& operator=(const KernelSamples&) = delete;

  const std::vector<FramePlan>& plans() const { return plans_; }

 private:
  Mesh one_chunk_, many_chunks_;
  std::vector<FramePlan> plans_;
};

}  // namespace morphcl
