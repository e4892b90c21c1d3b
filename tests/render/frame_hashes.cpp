// frame_hashes WIDTH HEIGHT [reference] [small] [transparent] [samplesN] [channels] [FORMAT]: one line a frame of every
// test scene, "hash SCENE/FRAME", drawn by a process of its own under the environment that a test gives it. FORMAT: the
// name of a depth buffer; vertices are then drawn in their most accurate forms as well. small: fewer triangles, for a
// device that is interpreted. transparent: with alpha. samplesN: N samples a pixel. channels: all that there are, of
// scenes that move. An Error is printed and its exit code is the process's.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "host/image/pixel_hash.hpp"
#include "morphcl/error.hpp"
#include "morphcl/planner.hpp"
#include "morphcl/renderer.hpp"
#include "morphcl/session.hpp"
#include "tests/render/channel_scenes.hpp"
#include "tests/render/test_scenes.hpp"

int main(int count, char** values) {
  using namespace morphcl;
  if (count < 3) return 2;
  const int width = std::atoi(values[1]), height = std::atoi(values[2]);
  try {
    prepare_process(0);
    const std::vector<std::string> more(values + 3, values + count);
    const bool reference = std::find(more.begin(), more.end(), "reference") != more.end();
    const bool small = std::find(more.begin(), more.end(), "small") != more.end();
    const bool blends = std::find(more.begin(), more.end(), "transparent") != more.end();
    unsigned seed = 0;
    const bool with_all = std::find(more.begin(), more.end(), "channels") != more.end();
    int samples = 1;
    for (const int known : sample_counts)
      if (std::find(more.begin(), more.end(), fmt::format("samples{}", known)) != more.end()) samples = known;
    const auto format = more.empty() ? std::nullopt : depth_format_named(more.back());
    const std::shared_ptr<Session> session = reference ? nullptr : Session::open({});
    const auto renderer = reference ? make_reference_renderer() : make_device_renderer(session);
    for (test::TestScene& scene : test::test_scenes(width, height, small ? 300 : 3000)) {
      if (blends) scene.scene = test::transparent(std::move(scene.scene), seed++);
      if (with_all) scene.scene = test::with_channels(scene.scene, every_channel);
      scene.scene.image.samples = samples;
      if (format) {
        scene.scene.image.depth_format = *format;
        scene.scene.accuracy_pixels = 1e-9;
      }
      for (const std::int64_t frame : scene.frames) {
        const Plan plan = plan_frame(scene.scene, frame);
        FrameBuffer pixels = plan.make_frame();
        renderer->render(plan, pixels);
        fmt::print("{} {}/{}\n", pixel_hash(pixels), scene.name, frame);
      }
    }
    if (session) session->store_programs();
  } catch (const Error& error) {
    fmt::print("error {}\n", error.what());
    return error.exit_code();
  }
  return 0;
}
