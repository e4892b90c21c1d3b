#include "host/render/auto/first_situation.hpp"

#include "host/device/cache_dir.hpp"
#include "host/device/kernel_source.hpp"
#include "host/render/auto/frame_estimate.hpp"
#include "host/thread_count.hpp"

namespace morphcl {

namespace {

// With PoCL 3.1; seconds.
constexpr double opening = 0.07, self_test_compile = 0.6;

}  // namespace

FrameKernels not_known(const FrameKernels& kernels, const KnownKernels& known) {
  FrameKernels missing;
  for (const FrameKernel& kernel : kernels)
    if (!known.has(kernel_source(kernel.stage).text, kernel.options, kernel.name)) missing.insert(kernel);
  return missing;
}

void set_preparation(const FrameKernels& kernels, const KnownKernels& known, Situation& now) {
  const FrameKernels missing = not_known(kernels, known);
  const bool tested = known.has(kernel_source("self_test").text, "", self_test_note);
  now.compiles = !missing.empty() || !tested;
  now.preparing = opening + compile_seconds(missing) + (tested ? 0 : self_test_compile);
  now.storing = store_seconds(missing);
}

Situation first_situation(const FramePlan& plan, std::int64_t frames, const AutoOptions& options) {
  Situation now;
  now.frames_left = frames;
  now.threads = choose_thread_count(options.threads);
  now.reference_frame = estimated_reference_seconds(plan, now.threads);
  now.device_frame = estimated_device_seconds(now.reference_frame);
  set_preparation(frame_kernels(plan), KnownKernels(choose_cache_dir(options.cache_dir)), now);
  return now;
}

}  // namespace morphcl
