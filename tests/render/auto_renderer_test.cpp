// The auto renderer: the same pixels whoever draws, and only a device that gives them takes part.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "host/device/session_access.hpp"
#include "host/render/auto/auto_settings.hpp"
#include "host/render/auto/frame_kernels.hpp"
#include "morphcl/error.hpp"
#include "morphcl/job.hpp"
#include "morphcl/planner.hpp"
#include "morphcl/solids.hpp"
#include "tests/render/parity.hpp"
#include "tests/render/scene_builder.hpp"
#include "tests/render/shared_session.hpp"
#include "tests/render/test_scenes.hpp"
#include "tests/support/temporary_folder.hpp"

namespace morphcl::test {
namespace {

constexpr int auto_width = 96, auto_height = 64;

// Nothing follows from how long something takes: the device draws from the frame numbered `first` on (0, 1, 2, ... as
// they are drawn), and is waited for then.
std::function<Choice(const Situation&)> device_from(std::int64_t first) {
  return [first](const Situation& now) {
    if (now.device == DeviceState::ready) return now.frames_drawn < first ? Choice::reference : Choice::device;
    return now.frames_drawn < first ? Choice::prepare : Choice::wait;
  };
}

AutoSettings settings_with(std::function<Choice(const Situation&)> choose) {
  AutoSettings settings;
  settings.options.threads = 2;
  settings.choose = std::move(choose);
  return settings;
}

// Renders the frames and compares each with the reference; returns who drew them.
std::vector<std::string> draw_and_compare(AutoRenderer& renderer, const Scene& scene,
                                          const std::vector<std::int64_t>& frames) {
  const auto reference = make_reference_renderer();
  const Planner planner(scene);
  FrameBuffer expected = planner.plan(frames.front()).make_frame(), drawn = planner.plan(frames.front()).make_frame();
  std::vector<std::string> drawn_by;
  reference->forget();
  renderer.forget();
  for (const std::int64_t frame : frames) {
    const Plan plan = planner.plan(frame);
    reference->render(plan, expected);
    renderer.render(plan, drawn);
    EXPECT_TRUE(same_pixels(expected, drawn)) << "frame " << frame << " by " << renderer.drawn_by();
    drawn_by.push_back(renderer.drawn_by());
  }
  return drawn_by;
}

std::vector<std::int64_t> numbers(std::int64_t count) {
  std::vector<std::int64_t> all(static_cast<std::size_t>(count));
  for (std::int64_t i = 0; i < count; ++i) all[static_cast<std::size_t>(i)] = i * 10;
  return all;
}

std::string device_name() { return shared_session()->info().name; }

TEST(AutoRenderer, ThePixelsAreTheReferencesBeforeAndAfterTheDeviceTakesOver) {
  for (const std::int64_t first : {0, 3}) {
    const auto renderer = make_auto_renderer(settings_with(device_from(first)));
    const auto drawn_by = draw_and_compare(*renderer, pyramid_to_cube(auto_width, auto_height), numbers(7));
    for (std::size_t i = 0; i < drawn_by.size(); ++i)
      EXPECT_EQ(drawn_by[i], static_cast<std::int64_t>(i) < first ? "reference" : device_name()) << i;
    EXPECT_EQ(renderer->note(), "");
    EXPECT_EQ(renderer->device_name(), device_name());
  }
}

TEST(AutoRenderer, EveryTestSceneHasTheReferencesPixels) {
  const auto renderer = make_auto_renderer(settings_with(device_from(1)));
  std::set<std::string> drew;
  for (const TestScene& scene : test_scenes(auto_width, auto_height, 300)) {
    SCOPED_TRACE(scene.name);
    for (const std::string& name : draw_and_compare(*renderer, scene.scene, scene.frames)) drew.insert(name);
  }
  EXPECT_EQ(drew, (std::set<std::string>{"reference", device_name()}));
  EXPECT_EQ(renderer->note(), "");
}

// The device gives the turn back as well: to a renderer that drew before, and may know nothing of the frames between.
TEST(AutoRenderer, TheTurnMayGoBackAndForth) {
  const auto renderer = make_auto_renderer(settings_with([](const Situation& now) {
    if (now.device == DeviceState::ready) return now.frames_drawn % 3 == 0 ? Choice::reference : Choice::device;
    return Choice::wait;
  }));
  const auto drawn_by = draw_and_compare(*renderer, pyramid_to_cube(auto_width, auto_height), numbers(9));
  EXPECT_EQ(std::count(drawn_by.begin(), drawn_by.end(), "reference"), 3);
}

// Kernels for clipping are compiled when the first frame needs them, which the reference draws, and no frame before.
TEST(AutoRenderer, AFrameThatNeedsAnotherKernelDoesNotWaitForIt) {
  const test_support::TemporaryFolder folder;
  bool waits = true;
  AutoSettings settings = settings_with([&waits](const Situation& now) {
    if (now.device == DeviceState::ready) return Choice::device;
    return waits ? Choice::wait : Choice::reference;
  });
  settings.options.cache_dir = folder.path().string();
  const auto renderer = make_auto_renderer(settings);
  const auto turns = [&](const Scene& scene) { return draw_and_compare(*renderer, scene, {0, 0}); };
  EXPECT_EQ(turns(pyramid_to_cube(auto_width, auto_height)), std::vector(2, device_name()));
  waits = false;
  const Scene soup = triangle_soup(1, 20, auto_width, auto_height);
  const Plan clipped = plan_frame(soup, 0);
  EXPECT_TRUE(clipped->clips);
  EXPECT_EQ(turns(soup), std::vector<std::string>(2, "reference"));
  waits = true;
  EXPECT_EQ(turns(soup), std::vector(2, device_name()));
}

// Those that other scenes need are not compiled with them.
TEST(AutoRenderer, AFrameThatNeedsAnotherKernelHasThatAloneCompiled) {
  const test_support::TemporaryFolder folder;
  std::shared_ptr<Session> session;
  AutoSettings settings = settings_with(device_from(0));
  settings.options.cache_dir = folder.path().string();
  settings.open = [&session](const SessionOptions& options) { return session = Session::open(options); };
  const auto renderer = make_auto_renderer(settings);
  const auto scene = [](double distance) {
    SceneBuilder builder(auto_width, auto_height);
    builder.add(make_torus({96, 48}), Shading::unlit);
    return builder.look({0, 0, distance}).scene();
  };
  const Scene outside = scene(4), inside = scene(0.65);
  const Plan whole = plan_frame(outside, 0), cut = plan_frame(inside, 0);
  EXPECT_FALSE(whole->clips);
  EXPECT_TRUE(cut->clips);
  draw_and_compare(*renderer, outside, {0});
  const auto compiled = [&session](const char* stage, const char* name) {
    return is_compiled(*session, kernel_source(stage), name, "");
  };
  EXPECT_TRUE(compiled("bin_primitives", "bin_primitives"));
  EXPECT_FALSE(compiled("clip_primitives", "clip_primitives"));
  draw_and_compare(*renderer, inside, {0});
  EXPECT_TRUE(compiled("clip_primitives", "clip_primitives"));
  for (const char* other : {"light_and_bin_primitives", "project_light_and_bin"})
    EXPECT_FALSE(compiled("bin_primitives", other)) << other;
}

TEST(AutoRenderer, ADeviceThatRoundsDifferentlyTakesNoPart) {
  AutoSettings settings = settings_with(device_from(0));
  settings.open = [](SessionOptions options) {
    options.cache_dir = "-";
    return open_session(options, [](std::string text) {
      if (const std::size_t at = text.find("convert_float_rte"); at != std::string::npos)
        text.replace(at, std::string("convert_float_rte").size(), "convert_float_rtz");
      return text;
    });
  };
  const auto renderer = make_auto_renderer(settings);
  const auto drawn_by = draw_and_compare(*renderer, pyramid_to_cube(auto_width, auto_height), numbers(3));
  EXPECT_EQ(drawn_by, std::vector<std::string>(3, "reference"));
  EXPECT_NE(renderer->note().find("rounds differently"), std::string::npos) << renderer->note();
  EXPECT_EQ(renderer->device_name(), "");
}

TEST(AutoRenderer, WithoutADeviceTheReferenceDrawsAndTheNoteSaysWhy) {
  int asked = 0;
  AutoSettings settings = settings_with(device_from(1));
  settings.open = [&asked](const SessionOptions&) -> std::shared_ptr<Session> {
    ++asked;
    throw Error(ErrorKind::no_device, "", "there is none today");
  };
  const auto renderer = make_auto_renderer(settings);
  EXPECT_EQ(draw_and_compare(*renderer, pyramid_to_cube(auto_width, auto_height), numbers(4)),
            std::vector<std::string>(4, "reference"));
  EXPECT_EQ(renderer->note(), "there is none today");
  EXPECT_EQ(asked, 1);
}

TEST(AutoRenderer, AKernelThatDoesNotCompileTakesTheDeviceOut) {
  AutoSettings settings = settings_with(device_from(1));
  settings.open = [](SessionOptions options) {
    options.cache_dir = "-";
    return open_session(options, [](const std::string& text) {
      return text == kernel_source("shade_tiles").text ? text + "\nno kernel\n" : text;
    });
  };
  const auto renderer = make_auto_renderer(settings);
  EXPECT_EQ(draw_and_compare(*renderer, pyramid_to_cube(auto_width, auto_height), numbers(4)),
            std::vector<std::string>(4, "reference"));
  EXPECT_NE(renderer->note().find("shade_tiles"), std::string::npos) << renderer->note();
}

// The destructor waits for the kernel in work and leaves the rest; a second one is not bothered by the first.
TEST(AutoRenderer, ItMayGoWhileItsThreadCompiles) {
  const Scene scene = pyramid_to_cube(auto_width, auto_height);
  const Plan plan = plan_frame(scene, 0);
  FrameBuffer frame = plan.make_frame();
  AutoSettings settings = settings_with(device_from(100));
  settings.options.cache_dir = "-";
  for (int i = 0; i < 2; ++i) {
    const auto renderer = make_auto_renderer(settings);
    renderer->render(plan, frame);
    EXPECT_TRUE(renderer->is_preparing());
    EXPECT_EQ(renderer->drawn_by(), "reference");
  }
}

TEST(AutoRenderer, AJobSaysWhoDrewEachFrame) {
  const test_support::TemporaryFolder folder;
  const Scene scene = pyramid_to_cube(auto_width, auto_height);
  std::vector<std::int64_t> left;
  AutoSettings settings = settings_with([&left](const Situation& now) {
    if (now.device != DeviceState::ready && !(now.device == DeviceState::closed && left.size() == 2))
      left.push_back(now.frames_left);
    return device_from(2)(now);
  });
  const auto renderer = make_auto_renderer(settings);
  RenderJob job;
  job.pattern = folder / "f.####.exr";
  job.frames = {0, 10, 20, 30, 40, 50};
  const JobResult result = run(job, scene, *renderer);
  ASSERT_EQ(result.frames.size(), 6u);
  for (const FrameResult& frame : result.frames) {
    EXPECT_EQ(frame.status, FrameResult::Status::rendered) << frame.error;
    EXPECT_EQ(frame.drawn_by, frame.frame < 20 ? "reference" : device_name()) << frame.frame;
  }
  ASSERT_GE(left.size(), 2u);
  EXPECT_EQ(left[0], 6);
  EXPECT_EQ(left[1], 5);
}

TEST(AutoRenderer, RefusesWhatOtherRenderersRefuse) {
  const auto renderer = make_auto_renderer(AutoOptions{});
  const Scene scene = pyramid_to_cube(auto_width, auto_height), other = pyramid_to_cube(auto_width, auto_height);
  const Planner planner(scene), stranger(other);
  FrameBuffer frame = planner.plan(0).make_frame(), small(8, 8, {Channel::color, Channel::depth});
  EXPECT_THROW(renderer->render(planner.plan(0), small), Error);
  renderer->render(planner.plan(0), frame);
  EXPECT_THROW(renderer->render(stranger.plan(0), frame), Error);
  renderer->forget();
  renderer->render(stranger.plan(0), frame);
  EXPECT_THROW(make_auto_renderer(AutoOptions{.threads = -1, .cache_dir = ""}), Error);
}

TEST(ReferenceRenderer, ItsThreadsDrawTheSamePixels) {
  for (const TestScene& scene : test_scenes(auto_width, 37, 300)) {
    SCOPED_TRACE(scene.name);
    const Plan plan = plan_frame(scene.scene, scene.frames.front());
    FrameBuffer expected = plan.make_frame();
    make_reference_renderer()->render(plan, expected);
    for (const int threads : {2, 3, 37, 200}) {
      FrameBuffer frame = plan.make_frame();
      make_reference_renderer(threads)->render(plan, frame);
      EXPECT_TRUE(same_pixels(expected, frame)) << threads << " threads";
    }
  }
  EXPECT_THROW(make_reference_renderer(-1), Error);
  EXPECT_THROW(make_reference_renderer(4097), Error);
}

// What the plan shows of the kernels is what the device starts.
TEST(FrameKernels, AreThoseThatTheDeviceStarts) {
  for (const TestScene& scene : test_scenes(auto_width, auto_height, 3000)) {
    SCOPED_TRACE(scene.name);
    const Planner planner(scene.scene);
    FrameKernels started;
    const auto device =
        make_device_renderer(shared_session(), [&started](const FrameKernel& kernel) { started.insert(kernel); });
    const Plan plan = planner.plan(scene.frames.front());
    FrameBuffer frame = plan.make_frame();
    device->render(plan, frame);
    EXPECT_EQ(frame_kernels(*plan), started);
  }
}

TEST(FrameKernels, OfSeveralSamplesAreThoseThatTheDeviceStarts) {
  for (const TestScene& test : test_scenes(auto_width, auto_height, 3000))
    for (const bool depth : {false, true}) {
      SCOPED_TRACE(test.name);
      Scene scene = test.scene;
      scene.image.samples = 4;
      scene.image.channels.set(Channel::depth, depth);
      FrameKernels started;
      const auto device =
          make_device_renderer(shared_session(), [&started](const FrameKernel& kernel) { started.insert(kernel); });
      const Plan plan = plan_frame(scene, test.frames.front());
      FrameBuffer frame = plan.make_frame();
      device->render(plan, frame);
      EXPECT_EQ(frame_kernels(*plan), started);
    }
}

TEST(FrameKernels, SamplesStartThoseThatAreWantedAndNoOthers) {
  std::set<FrameKernels> choices;
  for (const TestScene& scene : test_scenes(auto_width, auto_height, 3000))
    choices.insert(frame_kernels(*plan_frame(scene.scene, scene.frames.front())));
  FramePlan fixed;
  fixed.depth_format = DepthFormat::fixed24;
  choices.insert(frame_kernels(fixed));
  for (const TestScene& scene : test_scenes(auto_width, auto_height, 3000))
    for (const bool depth : {false, true}) {
      Scene several = scene.scene;
      several.image.samples = 4;
      several.image.channels.set(Channel::depth, depth);
      choices.insert(frame_kernels(*plan_frame(several, scene.frames.front())));
    }
  EXPECT_GE(choices.size(), 10u);
  for (const FrameKernels& wanted : choices) {
    FrameKernels started;
    const auto device =
        make_device_renderer(shared_session(), [&started](const FrameKernel& kernel) { started.insert(kernel); });
    const KernelSamples samples(wanted);
    for (const FramePlan& plan : samples.plans()) {
      const Plan sample(plan);
      FrameBuffer frame = sample.make_frame();
      device->render(sample, frame);
    }
    EXPECT_EQ(started, wanted);
  }
  EXPECT_TRUE(KernelSamples({}).plans().empty());
}

// One kernel alone, as a later frame may ask for it.
TEST(FrameKernels, ASampleStartsEachKernel) {
  for (const char* stage : {"bin_primitives", "clip_primitives", "project_vertices", "shade_tiles"})
    for (const KernelSignature& kernel : kernel_source(stage).kernels) {
      FrameKernels started;
      const auto device =
          make_device_renderer(shared_session(), [&started](const FrameKernel& first) { started.insert(first); });
      const FrameKernel wanted{stage, kernel.name, ""};
      const KernelSamples samples({wanted});
      for (const FramePlan& plan : samples.plans()) {
        const Plan sample(plan);
        FrameBuffer frame = sample.make_frame();
        device->render(sample, frame);
      }
      EXPECT_TRUE(started.contains(wanted)) << kernel.name;
    }
}

}  // namespace
}  // namespace morphcl::test
