// The shots of demos/ need different things, and their plans say so; none of them changes a pixel.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>

#include "host/render/frame/frame_plan.hpp"
#include "morphcl/explain.hpp"
#include "morphcl/renderer.hpp"
#include "morphcl/scene.hpp"
#include "tests/render/parity.hpp"
#include "tests/render/shared_session.hpp"

namespace morphcl::test {
namespace {

std::vector<std::string> demo_shots() {
  std::vector<std::string> paths;
  for (const auto& entry : std::filesystem::directory_iterator(MORPHCL_DEMOS))
    if (entry.path().extension() == ".toml") paths.push_back(entry.path().string());
  std::sort(paths.begin(), paths.end());
  return paths;
}

Scene load(const std::string& path) {
  LoadOptions options;
  options.width = 160;
  options.height = 90;
  return load_scene(path, options);
}

std::int64_t middle_frame(const Scene& scene) {
  const std::vector<std::int64_t> frames = frame_numbers(scene.frames);
  return frames[frames.size() * 3 / 4];
}

TEST(DemoShots, NoTwoHaveTheSamePlan) {
  std::map<std::string, std::string> shots;  // by their plan
  for (const std::string& path : demo_shots()) {
    const Scene scene = load(path);
    std::string items;
    for (const PlanNote& note : explain(Planner(scene), middle_frame(scene)).notes)
      items += note.item + (note.done ? ": done\n" : ": left out\n");
    const auto [same, is_new] = shots.emplace(items, path);
    EXPECT_TRUE(is_new) << path << " and " << same->second << " have the plan\n" << items;
  }
  EXPECT_GE(shots.size(), 10u);
}

TEST(DemoShots, LeaveOutNothingThatShows) {
  const auto device = make_device_renderer(shared_session()), reference = make_reference_renderer();
  for (const std::string& path : demo_shots()) {
    SCOPED_TRACE(path);
    const Scene scene = load(path);
    const Planner usual(scene), nothing_left_out(scene, {.leave_out = false});
    const std::vector<std::int64_t> frames = frame_numbers(scene.frames);
    for (const std::int64_t frame : {frames.front(), middle_frame(scene), frames.back()}) {
      std::vector<FrameBuffer> pictures;
      for (const Planner* planner : {&usual, &nothing_left_out})
        for (Renderer* renderer : {reference.get(), device.get()}) {
          const Plan plan = planner->plan(frame);
          renderer->forget();
          renderer->render(plan, pictures.emplace_back(plan->width, plan->height, plan->channels));
          EXPECT_TRUE(same_pixels(pictures[0], pictures.back())) << "frame " << frame << " on " << renderer->name();
        }
    }
  }
}

}  // namespace
}  // namespace morphcl::test
