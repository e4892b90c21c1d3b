// morphcl_bench_draw: times morphcl on one scene, from the frame number to pixels in host memory.
//
// A frame is its plan and its rendering into planes of half R, G, B, A and float Z that the program then owns: what the
// tool does before it writes a file. Warm-up frames are not counted. --colors-only and --channels: no Z, and other
// channels beside these.

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "bench/morphcl_scene.hpp"
#include "bench/report.hpp"
#include "bench/rig_scene.hpp"
#include "host/render/frame/frame_plan.hpp"
#include "morphcl/error.hpp"
#include "morphcl/frame.hpp"
#include "morphcl/planner.hpp"
#include "morphcl/renderer.hpp"
#include "morphcl/session.hpp"

namespace morphcl::bench {

namespace {

struct Subject {
  Scene scene;
  SceneFigures figures;
  int frames;
};

Subject make_subject(const Options& options) {
  if (options.scene == "rig") {
    const int frames = options.frames > 0 ? options.frames : 24;
    Scene scene = rig_scene(options.amount > 0 ? options.amount : 256, options.width, options.height, frames);
    const SceneFigures figures{"rig",
                               scene.image.width,
                               scene.image.height,
                               1,
                               scene.meshes[0].positions.size(),
                               scene.meshes[0].triangles.size()};
    return {std::move(scene), figures, frames};
  }
  BenchScene bench = make_bench_scene(options.scene, options.width, options.height, options.amount);
  const int frames = options.frames > 0 ? options.frames : bench.frames;
  const SceneFigures figures = scene_figures(bench);
  return {morphcl_scene(bench, frames), figures, frames};
}

struct Picture {
  bool colors_only = false;
  std::vector<std::string> more_channels;
};

void run(const Options& options, const Picture& asked_for) {
  Subject subject = make_subject(options);
  subject.scene.image.samples = options.samples;
  subject.scene.image.channels.set(Channel::depth, !asked_for.colors_only);
  for (const std::string& name : asked_for.more_channels) {
    const std::optional<Channel> channel = channel_named(name);
    if (!channel) throw Error(ErrorKind::usage, "--channels", fmt::format("there is no channel \"{}\"", name));
    subject.scene.image.channels.insert(*channel);
  }
  SessionOptions session_options;
  session_options.threads = prepare_process(options.threads);
  const std::shared_ptr<Session> session = Session::open(session_options);
  const std::unique_ptr<Renderer> renderer = make_device_renderer(session);
  const Planner planner(subject.scene);
  FrameBuffer frame(subject.figures.width, subject.figures.height, subject.scene.image.channels);

  for (int i = 0; i < warm_up_frames; ++i) renderer->render(planner.plan(std::min(i, subject.frames - 1)), frame);
  session->store_programs();

  FrameTimes times({"plan", "render"});
  for (int i = 0; i < subject.frames; ++i) {
    times.start_frame();
    const Plan plan = planner.plan(i);
    times.finish_step();
    renderer->render(plan, frame);
    times.finish_step();
  }
  const std::size_t row_pitch = frame.row_bytes() / sizeof(std::uint16_t);
  const PictureView picture{frame.color_row(0, 0).data(),
                            frame.color_row(3, 0).data(),
                            subject.figures.width,
                            subject.figures.height,
                            row_pitch,
                            1};
  print_report("morphcl", session->info().platform, subject.figures, session_options.threads, times,
               picture_figures(picture));
}

}  // namespace

}  // namespace morphcl::bench

int main(int argc, char** argv) {
  try {
    morphcl::bench::Picture picture;
    const auto options = morphcl::bench::parse_options(
        argc, argv, "Times morphcl on a scene: plan and render to RGBA and Z.", [&picture](CLI::App& app) {
          app.add_flag("--colors-only", picture.colors_only, "RGBA without Z");
          app.add_option("--channels", picture.more_channels, "N,P,...: beside these")->delimiter(',');
        });
    if (options) morphcl::bench::run(*options, picture);
    return 0;
  } catch (const morphcl::Error& error) {
    fmt::print(stderr, "morphcl_bench_draw: {}\n", error.what());
    return error.exit_code();
  } catch (const std::exception& error) {
    fmt::print(stderr, "morphcl_bench_draw: {}\n", error.what());
    return 70;
  }
}
