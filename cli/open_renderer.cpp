#include "cli/open_renderer.hpp"

#include <fmt/core.h>

#include <utility>

#include "cli/console.hpp"
#include "cli/stop_signals.hpp"
#include "host/end_process.hpp"
#include "host/thread_count.hpp"

namespace morphcl::cli {

namespace {

OpenedRenderer open_reference(const DeviceOptions& options) {
  OpenedRenderer opened;
  opened.threads = choose_thread_count(options.threads);
  opened.renderer = make_reference_renderer(opened.threads);
  opened.device_name = opened.renderer->name();
  return opened;
}

OpenedRenderer open_by_turns(const DeviceOptions& options) {
  OpenedRenderer opened;
  watch_driver_aborts();
  opened.threads = choose_thread_count(options.threads);
  std::unique_ptr<AutoRenderer> renderer = make_auto_renderer({.threads = options.threads, .cache_dir = ""});
  opened.by_turns = renderer.get();
  opened.device_name = renderer->name();
  opened.renderer = std::move(renderer);
  return opened;
}

OpenedRenderer open_device(const DeviceOptions& options) {
  OpenedRenderer opened;
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

}  // namespace

OpenedRenderer open_renderer(const DeviceOptions& options) {
  if (options.device == reference_name) return open_reference(options);
  if (options.device == auto_name) return open_by_turns(options);
  return open_device(options);
}

OpenedRenderer::~OpenedRenderer() {
  if (!renderer || by_turns == nullptr || !by_turns->is_preparing()) return;
  leave_thread_at_work();
  static_cast<void>(renderer.release());
}

void OpenedRenderer::store_programs() const {
  if (session) session->store_programs();
  if (by_turns) by_turns->store_programs();
}

void OpenedRenderer::warn_of_cache() const {
  const std::string trouble = session ? session->cache_trouble() : by_turns ? by_turns->cache_trouble() : "";
  if (!trouble.empty())
    print_message("warning: the compiled kernels are not kept, and every run compiles them anew: " + trouble);
}

std::string OpenedRenderer::note() const {
  const std::string trouble = by_turns ? by_turns->note() : "";
  return trouble.empty() ? "" : fmt::format("no device takes part, and the reference renderer draws: {}", trouble);
}

}  // namespace morphcl::cli
