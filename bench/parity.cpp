// morphcl_bench_parity SCENE [--amount N] [--frames N] [--size WxH] [--samples N]: whether what is timed is right.
// Draws the scene's first, middle and last frame by OpenCL, as planned and with nothing left out, and by the plain C++
// reference, and compares every bit. Prints one line of JSON; exit code 1 when something differs.
//
// Frames are drawn one after the other into the same pictures, as the timed programs do.

#include <fmt/format.h>

#include "bench/morphcl_scene.hpp"
#include "bench/options.hpp"
#include "bench/report.hpp"
#include "host/image/pixel_hash.hpp"
#include "morphcl/error.hpp"
#include "morphcl/frame.hpp"
#include "morphcl/planner.hpp"
#include "morphcl/renderer.hpp"
#include "morphcl/session.hpp"

namespace morphcl::bench {

namespace {

// One way to get the picture of a frame, with what it keeps from frame to frame.
struct Way {
  const char* name;
  Planner planner;
  std::unique_ptr<Renderer> renderer;
  FrameBuffer pixels;

  Way(const char* name_, const Scene& scene, bool leave_out, std::unique_ptr<Renderer> drawn_by)
      : name(name_),
        planner(scene, {.leave_out = leave_out}),
        renderer(std::move(drawn_by)),
        pixels(scene.image.width, scene.image.height, default_channels) {}

  std::string hash(std::int64_t frame) {
    renderer->render(planner.plan(frame), pixels);
    return pixel_hash(pixels);
  }
};

bool run(const Options& options) {
  BenchScene bench = make_bench_scene(options.scene, options.width, options.height, options.amount);
  const int frames = options.frames > 0 ? options.frames : bench.frames;
  Scene scene = morphcl_scene(bench, frames);
  scene.image.samples = options.samples;
  SessionOptions session_options;
  session_options.threads = prepare_process(options.threads);
  const std::shared_ptr<Session> session = Session::open(session_options);
  Way reference("reference", scene, true, make_reference_renderer());
  Way planned("as planned", scene, true, make_device_renderer(session));
  Way complete("nothing left out", scene, false, make_device_renderer(session));
  bool same = true;
  for (const std::int64_t frame : {0, frames / 2, frames - 1}) {
    const std::string expected = reference.hash(frame);
    for (Way* way : {&planned, &complete}) {
      const bool equal = way->hash(frame) == expected;
      if (!equal) fmt::print(stderr, "{}, frame {}, {}: not the reference's pixels\n", options.scene, frame, way->name);
      same &= equal;
    }
  }
  fmt::print(R"({{"scene":"{}","width":{},"height":{},"same":{}}})"
             "\n",
             options.scene, scene.image.width, scene.image.height, same);
  return same;
}

}  // namespace

}  // namespace morphcl::bench

int main(int argc, char** argv) {
  try {
    const auto options = morphcl::bench::parse_options(
        argc, argv, "Compares a scene's frames with the C++ reference, with and without what plans leave out.");
    return options && !morphcl::bench::run(*options) ? 1 : 0;
  } catch (const morphcl::Error& error) {
    fmt::print(stderr, "morphcl_bench_parity: {}\n", error.what());
    return error.exit_code();
  } catch (const std::exception& error) {
    fmt::print(stderr, "morphcl_bench_parity: {}\n", error.what());
    return 70;
  }
}
