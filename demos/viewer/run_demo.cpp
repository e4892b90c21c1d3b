#include "demos/viewer/run_demo.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <exception>

#include "demos/viewer/demo_renderer.hpp"
#include "demos/viewer/demo_session.hpp"
#include "demos/viewer/frame_source.hpp"
#include "demos/viewer/options.hpp"
#include "demos/viewer/run_headless.hpp"
#include "demos/viewer/run_window.hpp"
#include "demos/viewer/shot_path.hpp"
#include "host/end_process.hpp"
#include "host/standard_streams.hpp"
#include "morphcl/error.hpp"
#include "morphcl/scene.hpp"
#include "morphcl/session.hpp"

namespace morphcl::viewer {
namespace {

// Sets variables of the environment and starts a process, so it comes before the window, whose driver has threads.
void prepare(const DemoOptions& options) {
  if (options.device == "reference") return;
  try {
    prepare_process(options.threads);
  } catch (const Error& error) {
    if (options.device != "auto" || error.kind() != ErrorKind::no_device) throw;  // the reference does without
  }
}

void run(const DemoSettings& settings, const DemoOptions& options) {
  prepare(options);
  std::unique_ptr<Window> window;
  if (!options.headless) window = std::make_unique<Window>(settings.name, options.size);

  LoadOptions load;  // a fitted camera frames for the size at the start
  load.width = options.size.width;
  load.height = options.size.height;
  Scene scene = load_scene(options.shot.empty() ? find_shot(settings.shot) : options.shot, load);
  for (const std::string& warning : scene.warnings) fmt::print(stderr, "{}: {}\n", settings.name, printable(warning));
  DemoRenderer renderer(options.device, options.threads);
  FrameSource frames(std::move(scene), settings, renderer);
  DemoSession session(settings, frames);
  if (window) {
    const double ticks_per_second = settings.turning.value_or(Turning{}).ticks_per_second;
    run_window(*window, session, options.script, frames.frames_per_second(), ticks_per_second);
    window.reset();
  } else {
    run_headless(frames, session, options.script, options.size, options.out);
  }
  renderer.store_programs();
}

// Returns the exit code.
int run_and_report(const DemoSettings& settings, const DemoSettings* deck, int argc, const char* const* argv) {
  try {
    if (const auto options = parse_options(settings, deck, argc, argv)) run(options->deck ? *deck : settings, *options);
    return 0;
  } catch (const Error& error) {
    fmt::print(stderr, "{}: {}\n", settings.name, error.what());
    return error.exit_code();
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}: {}\n", settings.name, printable(error.what()));
    return static_cast<int>(ErrorKind::internal);
  }
}

}  // namespace

int run_demo(const DemoSettings& settings, int argc, const char* const* argv, const DemoSettings* deck) {
  open_closed_standard_streams();
  const int code = run_and_report(settings, deck, argc, argv);
  if (thread_left_at_work()) {
    std::fflush(nullptr);
    end_process(code);
  }
  return code;
}

}  // namespace morphcl::viewer
