#include "cli/open_renderer.hpp"

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
  opened.threads = prepare_process(options.threads);
  SessionOptions session;
  session.device = options.device;
  session.threads = opened.threads;
  opened.session = Session::open(session);
  opened.renderer = make_device_renderer(opened.session);
  opened.device_name = opened.session->info().name;
  return opened;
}

void OpenedRenderer::store_programs() const {
  if (session) session->store_programs();
}

}  // namespace morphcl::cli
