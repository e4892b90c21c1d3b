#include "demos/viewer/demo_renderer.hpp"

#include "host/end_process.hpp"
#include "host/render/auto/auto_settings.hpp"

namespace morphcl::viewer {
namespace {

constexpr std::int64_t frames_to_come = 1000;

// Somebody looks: late frames that come sooner are worth nothing against a window that stands still.
Choice choose_for_a_window(const Situation& now) {
  const Choice choice = choose(now);
  return choice == Choice::wait ? Choice::prepare : choice;
}

}  // namespace

DemoRenderer::DemoRenderer(const std::string& device, int threads) {
  if (device == "reference") {
    renderer_ = make_reference_renderer(threads);
  } else if (device == "auto") {
    AutoSettings settings;
    settings.options.threads = threads;
    settings.choose = choose_for_a_window;
    std::unique_ptr<AutoRenderer> renderer = make_auto_renderer(settings);
    by_turns_ = renderer.get();
    renderer_ = std::move(renderer);
  } else {
    SessionOptions options;
    options.device = device;
    options.threads = threads;
    session_ = Session::open(options);
    renderer_ = make_device_renderer(session_);
  }
}

DemoRenderer::~DemoRenderer() {
  if (by_turns_ == nullptr || !by_turns_->is_preparing()) return;
  leave_thread_at_work();
  static_cast<void>(renderer_.release());
}

Renderer& DemoRenderer::for_next_frame() {
  if (by_turns_) by_turns_->expect_frames(frames_to_come);
  return *renderer_;
}

void DemoRenderer::store_programs() {
  if (session_) session_->store_programs();
  if (by_turns_) by_turns_->store_programs();
}

}  // namespace morphcl::viewer
