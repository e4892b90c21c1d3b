#include "cli/warm_command.hpp"

#include <fmt/core.h>

#include <chrono>
#include <optional>
#include <set>

#include "cli/console.hpp"
#include "cli/exit_code.hpp"
#include "cli/warm_scene.hpp"
#include "host/device/session_access.hpp"
#include "host/render/auto/frame_kernels.hpp"
#include "morphcl/error.hpp"
#include "morphcl/planner.hpp"

namespace morphcl::cli {

namespace {

void compile_usual_kernels(Renderer& renderer) {
  for (const Scene& scene : warm_scenes()) {
    FrameBuffer frame(scene.image.width, scene.image.height, scene.image.channels);
    renderer.render(plan_frame(scene, 0), frame);
  }
}

// Those that its frames start, each compiled by a small frame that starts it.
void compile_kernels_of(const Scene& scene, Renderer& renderer) {
  const Planner planner(scene);
  std::set<FrameKernels> different;
  for (const std::int64_t frame : frame_numbers(scene.frames)) different.insert(frame_kernels(*planner.plan(frame)));
  for (const FrameKernels& kernels : different) {
    const KernelSamples samples(kernels);
    for (const FramePlan& sample : samples.plans()) {
      const Plan plan(sample);
      FrameBuffer frame = plan.make_frame();
      renderer.render(plan, frame);
    }
  }
}

}  // namespace

int warm_command(const WarmOptions& options) {
  const std::string& device = options.device.device;
  if (device == reference_name)
    throw Error(ErrorKind::usage, "--device", "the reference renderer compiles nothing; an OpenCL device");
  std::optional<Scene> scene;
  if (!options.scene.path.empty()) {
    scene = open_scene(options.scene);
    print_warnings(*scene);
  }
  const auto start = std::chrono::steady_clock::now();
  // What the auto renderer lets draw is the default device.
  const OpenedRenderer opened = open_renderer({device == auto_name ? "" : device, options.device.threads});
  if (scene)
    compile_kernels_of(*scene, *opened.renderer);
  else
    compile_usual_kernels(*opened.renderer);
  opened.store_programs();
  store_binaries(*opened.session);
  if (const std::string trouble = opened.session->cache_trouble(); !trouble.empty())
    throw Error(ErrorKind::cannot_create, "", "the kernels are compiled and cannot be kept: " + trouble);
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  print_result(fmt::format("kernels ready for {} after {:.2f} s", opened.device_name, elapsed.count()));
  return exit_done;
}

}  // namespace morphcl::cli
