#include "cli/warm_command.hpp"

#include <fmt/core.h>

#include <chrono>

#include "cli/console.hpp"
#include "cli/exit_code.hpp"
#include "cli/warm_scene.hpp"
#include "host/device/session_access.hpp"
#include "morphcl/error.hpp"
#include "morphcl/planner.hpp"

namespace morphcl::cli {

int warm_command(const DeviceOptions& options) {
  if (options.device == reference_name)
    throw Error(ErrorKind::usage, "--device", "the reference renderer compiles nothing; an OpenCL device");
  const auto start = std::chrono::steady_clock::now();
  // What the auto renderer lets draw is the default device.
  const OpenedRenderer opened = open_renderer({options.device == auto_name ? "" : options.device, options.threads});
  for (const Scene& scene : warm_scenes()) {
    FrameBuffer frame(scene.image.width, scene.image.height, scene.image.channels);
    opened.renderer->render(plan_frame(scene, 0), frame);
  }
  opened.store_programs();
  store_binaries(*opened.session);
  if (const std::string trouble = opened.session->cache_trouble(); !trouble.empty())
    throw Error(ErrorKind::cannot_create, "", "the kernels are compiled and cannot be kept: " + trouble);
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  print_result(fmt::format("kernels ready for {} after {:.2f} s", opened.device_name, elapsed.count()));
  return exit_done;
}

}  // namespace morphcl::cli
