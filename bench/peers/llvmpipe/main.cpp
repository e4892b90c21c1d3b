// morphcl_peer_llvmpipe: what one would use without morphcl: OpenGL on Mesa's CPU rasteriser, drawn into a half RGBA
// framebuffer and read back. Same scenes, options and report as morphcl_bench_draw.

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "bench/options.hpp"
#include "bench/peers/llvmpipe/context.hpp"
#include "bench/peers/llvmpipe/gl_scene.hpp"
#include "bench/peers/llvmpipe/target.hpp"
#include "bench/report.hpp"
#include "bench/scenes.hpp"
#include "host/error.hpp"

namespace morphcl::bench {

namespace {

using Clock = std::chrono::steady_clock;

double milliseconds(Clock::time_point from, Clock::time_point to) {
  return std::chrono::duration<double, std::milli>(to - from).count();
}

void run(const Options& options) {
  const BenchScene bench = make_bench_scene(options.scene, options.width, options.height);
  const int frames = options.frames > 0 ? options.frames : bench.frames;
  const auto t_of = [&](int frame) {
    return frames > 1 ? static_cast<float>(frame) / static_cast<float>(frames - 1) : 0.0f;
  };
  make_llvmpipe_context(options.threads);
  const GlScene scene(bench);
  RenderTarget target(bench.width, bench.height);

  for (int i = 0; i < warm_up_frames; ++i) {
    scene.draw(t_of(std::min(i, frames - 1)));
    target.read_back();
  }
  FrameTimes times("draw", "read");
  for (int i = 0; i < frames; ++i) {
    const Clock::time_point start = Clock::now();
    scene.draw(t_of(i));
    const Clock::time_point drawn = Clock::now();
    target.read_back();
    times.add(milliseconds(start, drawn), milliseconds(drawn, Clock::now()));
  }
  if (const GLenum error = gl::GetError())
    throw Error(ErrorKind::internal, "", fmt::format("OpenGL error {:#x}", error));
  const std::uint16_t* pixels = target.pixels().data();
  const PictureView picture{pixels, pixels + 3, bench.width, bench.height, 4 * static_cast<std::size_t>(bench.width),
                            4};
  print_report("llvmpipe", renderer_name(), bench, options, times, picture_figures(picture));
}

}  // namespace

}  // namespace morphcl::bench

int main(int argc, char** argv) {
  try {
    const auto options = morphcl::bench::parse_options(
        argc, argv, "Times OpenGL on llvmpipe on a scene: draw and read back to half RGBA.");
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
