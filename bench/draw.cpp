// morphcl_bench_draw: times morphcl on one scene, from the frame number to pixels in host memory.
//
// A frame is its plan and its rendering into planes of half R, G, B, A and float Z that the program then owns: what the
// tool does before it writes a file. Warm-up frames are not counted.

#include <fmt/format.h>

#include <chrono>

#include "bench/morphcl_scene.hpp"
#include "bench/report.hpp"
#include "host/device/session.hpp"
#include "host/error.hpp"
#include "host/image/frame_buffer.hpp"
#include "host/render/device_renderer.hpp"
#include "host/render/plan.hpp"

namespace morphcl::bench {

namespace {

using Clock = std::chrono::steady_clock;

double milliseconds(Clock::time_point from, Clock::time_point to) {
  return std::chrono::duration<double, std::milli>(to - from).count();
}

void run(Options options) {
  const BenchScene bench = make_bench_scene(options.scene, options.width, options.height);
  const int frames = options.frames > 0 ? options.frames : bench.frames;
  const Scene scene = morphcl_scene(bench, frames);
  options.threads = prepare_process(options.threads);
  SessionOptions session_options;
  session_options.threads = options.threads;
  const std::shared_ptr<Session> session = Session::open(session_options);
  const std::unique_ptr<Renderer> renderer = make_device_renderer(session);
  const Planner planner(scene);
  FrameBuffer frame(bench.width, bench.height, true, true);

  for (int i = 0; i < warm_up_frames; ++i) renderer->render(planner.plan(std::min(i, frames - 1)), frame);
  session->store_programs();

  FrameTimes times("plan", "render");
  for (int i = 0; i < frames; ++i) {
    const Clock::time_point start = Clock::now();
    const FramePlan plan = planner.plan(i);
    const Clock::time_point planned = Clock::now();
    renderer->render(plan, frame);
    times.add(milliseconds(start, planned), milliseconds(planned, Clock::now()));
  }
  const PictureView picture{frame.color(0), frame.color(3), bench.width, bench.height, frame.row_pitch(), 1};
  print_report("morphcl", session->info().platform, bench, options, times, picture_figures(picture));
}

}  // namespace

}  // namespace morphcl::bench

int main(int argc, char** argv) {
  try {
    const auto options =
        morphcl::bench::parse_options(argc, argv, "Times morphcl on a scene: plan and render to RGBA and Z.");
    if (options) morphcl::bench::run(*options);
    return 0;
  } catch (const morphcl::Error& error) {
    fmt::print(stderr, "morphcl_bench_draw: {}\n", error.what());
    return error.exit_code();
  } catch (const std::exception& error) {
    fmt::print(stderr, "morphcl_bench_draw: {}\n", error.what());
    return 70;
  }
}
