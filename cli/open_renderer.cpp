#include "cli/open_renderer.hpp"

#include <fmt/core.h>

#include "cli/console.hpp"
#include "cli/stop_signals.hpp"
#include "morphcl/renderer.hpp"

namespace morphcl::cli {

OpenedRenderer open_renderer(const DeviceOptions& options) {
  OpenedRenderer opened;
  if (options.device == "reference") {
    opened.renderer = make_reference_renderer();
    opened.device_name = opened.renderer->name();
    opened.threads = options.threads;
    return opened;
  }
  watch_driver_aborts();
  opened.threads = prepare_process(options.threads);
  SessionOptions session;
  session.device = options.device;
  session.threads = opened.threads;
  opened.session = Session::open(session);
  opened.renderer = make_device_renderer(opened.session);
  opened.device_name = opened.session->info().name;
  if (opened.session->verdict() != Verdict::identical)
    print_message(
        fmt::format("warning: device \"{}\" rounds differently ({}), so pixels may differ in their last bits "
                    "from those of other devices; the frames say so, and --resume does not mix them",
                    opened.device_name, opened.session->verdict_detail()));
  return opened;
}

void OpenedRenderer::store_programs() const {
  if (session) session->store_programs();
}

void OpenedRenderer::warn_of_cache() const {
  const std::string trouble = session ? session->cache_trouble() : "";
  if (!trouble.empty())
    print_message("warning: the compiled kernels are not kept, and every run compiles them anew: " + trouble);
}

}  // namespace morphcl::cli
