// morphcl_peer_llvmpipe: what one would use without morphcl: OpenGL on Mesa's CPU rasteriser, drawn into a half RGBA
// framebuffer, read back, and with --out written by OpenEXR. Same scenes, options and report as morphcl_bench_draw.
//
// With --out there are no warm-up frames, and a line of JSON {"frame": N, "path": "..."} says that a file is complete.

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>

#include "bench/peers/llvmpipe/context.hpp"
#include "bench/peers/llvmpipe/exr_writer.hpp"
#include "bench/peers/llvmpipe/gl_scene.hpp"
#include "bench/peers/llvmpipe/peer_options.hpp"
#include "bench/peers/llvmpipe/target.hpp"
#include "bench/report.hpp"
#include "bench/scenes.hpp"
#include "morphcl/error.hpp"

namespace morphcl::bench {

namespace {

float t_of(int frame, int frames) {
  return frames > 1 ? static_cast<float>(frame) / static_cast<float>(frames - 1) : 0.0f;
}

FrameTimes draw_frames(const PeerOptions& options, int frames, const GlScene& scene, RenderTarget& target) {
  for (int i = 0; i < warm_up_frames; ++i) {
    target.start_frame();
    scene.draw(t_of(std::min(i, frames - 1), frames));
    target.read_back();
  }
  FrameTimes times({"draw", "read"});
  for (int i = options.part; i < frames; i += options.parts) {
    times.start_frame();
    target.start_frame();
    scene.draw(t_of(i, frames));
    times.finish_step();
    target.read_back();
    times.finish_step();
  }
  return times;
}

FrameTimes write_frames(const PeerOptions& options, int frames, const BenchScene& bench, const GlScene& scene,
                        RenderTarget& target) {
  ExrSettings settings;
  settings.zlib_level = options.zip_level;
  settings.threads_aside = options.threads > 1 ? options.threads : 0;
  const ExrWriter writer(settings);
  FrameTimes times({"draw", "read", "write"});
  for (int i = options.part; i < frames; i += options.parts) {
    const std::string path = fmt::format("{}/{}.{:04}.exr", options.out, bench.name, i);
    times.start_frame();
    target.start_frame();
    scene.draw(t_of(i, frames));
    times.finish_step();
    target.read_back();
    times.finish_step();
    writer.write(path, target.pixels().data(), bench.width, bench.height);
    times.finish_step();
    fmt::print("{{\"frame\": {}, \"path\": \"{}\"}}\n", i, path);
    std::fflush(stdout);
  }
  return times;
}

void run(const PeerOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  const BenchScene bench = make_bench_scene(options.scene, options.width, options.height, options.amount);
  SceneFigures figures = scene_figures(bench);
  figures.scene_ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  const int frames = options.frames > 0 ? options.frames : bench.frames;
  if (options.part >= frames)
    throw Error(ErrorKind::usage, "", fmt::format("--part {}: there are {} frames", options.part, frames));
  make_llvmpipe_context(options.threads);
  const GlScene scene(bench);
  RenderTarget target(bench.width, bench.height, options.samples, options.resolve_by_shader);
  const FrameTimes times = options.out.empty() ? draw_frames(options, frames, scene, target)
                                               : write_frames(options, frames, bench, scene, target);
  if (const GLenum error = gl::GetError())
    throw Error(ErrorKind::internal, "", fmt::format("OpenGL error {:#x}", error));
  const std::uint16_t* pixels = target.pixels().data();
  const PictureView picture{pixels, pixels + 3, bench.width, bench.height, 4 * static_cast<std::size_t>(bench.width),
                            4};
  print_report("llvmpipe", renderer_name(), figures, options.threads, times, picture_figures(picture));
}

}  // namespace

}  // namespace morphcl::bench

int main(int argc, char** argv) {
  try {
    const auto options = morphcl::bench::parse_peer_options(argc, argv);
    if (options) morphcl::bench::run(*options);
    return 0;
  } catch (const morphcl::Error& error) {
    fmt::print(stderr, "morphcl_peer_llvmpipe: {}\n", error.what());
    return error.exit_code();
  } catch (const std::exception& error) {
    fmt::print(stderr, "morphcl_peer_llvmpipe: {}\n", error.what());
    return 70;
  }
}
