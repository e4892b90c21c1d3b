// A plan in words: what it says about blank tiles, earlier frames, costs and memory is true of what is drawn.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "host/render/explain/earlier_frames.hpp"
#include "host/render/explain/screen_reach.hpp"
#include "host/render/frame/frame_plan.hpp"
#include "morphcl/explain.hpp"
#include "morphcl/renderer.hpp"
#include "morphcl/solids.hpp"
#include "tests/render/scene_builder.hpp"
#include "tests/render/test_scenes.hpp"

namespace morphcl::test {
namespace {

const PlanNote* find_note(const PlanReport& report, const std::string& item) {
  const auto found =
      std::find_if(report.notes.begin(), report.notes.end(), [&](const PlanNote& note) { return note.item == item; });
  return found == report.notes.end() ? nullptr : &*found;
}

PlanReport report_of(const Scene& scene, std::int64_t frame, const PlanOptions& options = {}) {
  return explain(Planner(scene, options), frame);
}

// A box that morphs out in frames 0 to 10, stays until 14 and comes back until 24, beside one that never moves.
Scene there_and_back() {
  SceneBuilder b(320, 192);
  b.add(make_pyramid_to_cube(), Shading::flat, place({-2.2, -1, -0.65}, 0.01));
  b.add(make_cube(), Shading::flat, place({1.2, 0, 0}, 0.4));
  Timeline& timeline = b.look({0, 0, 6}).scene().timeline;
  const auto ticks = [&](std::int64_t frame) { return timeline.time.frame_ticks(frame); };
  b.scene().objects[0].morph.tracks.push_back({0, Track({Interpolation::linear,
                                                         1,
                                                         false,
                                                         timeline.time.ticks_per_second(),
                                                         {ticks(0), ticks(10), ticks(14), ticks(24)},
                                                         {0, 1, 1, 0}})});
  b.scene().frames = {{0, 24, 1}};
  return b.scene();
}

TEST(ScreenReach, HoldsEveryPixelThatIsDrawn) {
  const auto renderer = make_reference_renderer();
  std::size_t blank = 0;
  for (TestScene& test : test_scenes(333, 211)) {
    test.scene.image.background.reset();  // it reaches every pixel
    for (const std::int64_t frame : test.frames) {
      const Plan plan = plan_frame(test.scene, frame);
      const ScreenReach reach = find_reach(*plan);
      ASSERT_EQ(reach.tile_columns, 6);
      ASSERT_EQ(reach.tile_rows, 4);
      FrameBuffer pixels(plan->width, plan->height, {Channel::color, Channel::depth});
      renderer->render(plan, pixels);
      for (int y = 0; y < plan->height; ++y)
        for (int x = 0; x < plan->width; ++x)
          ASSERT_TRUE(pixels.color_row(3, y)[x] == 0 || reach.reached[y / 64 * 6 + x / 64])
              << test.name << " frame " << frame << " pixel " << x << ' ' << y;
      blank += 24 - reach.reached_tiles;
      EXPECT_LE(reach.reached_pixels, 333.0 * 211.0);
    }
  }
  EXPECT_GT(blank, 50u);
}

TEST(ScreenReach, CountsPixelsOfCutTilesAndBlankRows) {
  SceneBuilder b(100, 200);
  b.add(make_cube(), Shading::flat, place({0.2, 0, 0}, 0.01));
  const ScreenReach reach = find_reach(*plan_frame(b.look({0, 0, 5}).scene(), 0));
  EXPECT_EQ(reach.reached_tiles, 1u);  // right of the middle at x = 50: the tile from 64 to 100, if it reaches so far
  EXPECT_EQ(reach.blank_rows, 200 - 64);
  EXPECT_EQ(reach.reached_pixels, 64.0 * 64.0);
}

TEST(PlanReport, NamesUnchangedObjects) {
  const Scene scene = there_and_back();
  const PlanReport moving = report_of(scene, 5), held = report_of(scene, 12);
  ASSERT_TRUE(find_note(moving, "unchanged objects"));
  EXPECT_EQ(find_note(moving, "unchanged objects")->reason,
            "1 of 2 as in frame 4: drawn after it, their vertices stay");
  EXPECT_EQ(find_note(held, "unchanged objects")->reason, "2 of 2 as in frame 11: drawn after it, their vertices stay");
  EXPECT_FALSE(find_note(held, "unchanged objects")->done);
  EXPECT_TRUE(find_note(report_of(scene, 12, {.leave_out = false}), "unchanged objects")->done);
  EXPECT_EQ(find_note(report_of(scene, 0), "unchanged objects"), nullptr) << "the shot's first frame";
  Scene zooming = scene;  // changes the matrices to clip space alone
  Timeline& timeline = zooming.timeline;
  timeline.camera.fovy_track = Track({Interpolation::linear,
                                      1,
                                      false,
                                      timeline.time.ticks_per_second(),
                                      {0, timeline.time.frame_ticks(24)},
                                      {45, 60}});
  EXPECT_EQ(find_note(report_of(zooming, 12), "unchanged objects"), nullptr);
}

TEST(PlanReport, FindsTheLatestEarlierFrameWithTheSamePicture) {
  const Scene scene = there_and_back();
  const Planner planner(scene);
  const auto equal = [&](std::int64_t frame) { return find_equal_frame(planner, *planner.plan(frame)); };
  EXPECT_EQ(equal(0), std::nullopt);
  EXPECT_EQ(equal(10), std::nullopt);
  EXPECT_EQ(equal(13), 12);
  EXPECT_EQ(equal(19), 5);
  EXPECT_EQ(equal(30), 24);  // beyond the shot the last values hold
  Scene odd_frames = scene;
  odd_frames.frames = {{1, 23, 2}};
  const Planner of_odd_frames(odd_frames);
  EXPECT_EQ(find_equal_frame(of_odd_frames, *of_odd_frames.plan(13)), 11);
  EXPECT_EQ(find_note(report_of(scene, 19), "equal frame")->reason,
            "the picture of frame 5: drawn after it, it is copied");
  EXPECT_EQ(find_note(report_of(scene, 5), "equal frame"), nullptr);
}

TEST(PlanReport, CostsAreThereForWhatIsDoneAndForWhatIsSaved) {
  for (const TestScene& test : test_scenes(150, 90)) {
    const PlanReport report = report_of(test.scene, 0);
    EXPECT_GT(report.milliseconds, 0) << test.name;
    for (const PlanNote& note : report.notes) {
      EXPECT_TRUE(std::isfinite(note.milliseconds) && note.milliseconds >= 0) << test.name << ": " << note.item;
      if (note.item == "objects" || note.item == "vertex normals") {
        EXPECT_EQ(note.milliseconds > 0, note.done) << test.name << ": " << note.item;
      }
    }
  }
}

TEST(PlanReport, CostAndMemoryGrowWithTheWork) {
  const auto report = [](int segments, int width, int targets) {
    SceneBuilder b(width, width / 2);
    Mesh mesh = make_sphere({segments, segments / 2});
    for (int i = 0; i < targets; ++i)
      mesh.targets.push_back({std::to_string(i), TargetForm::delta, mesh.positions, {}, {}});
    b.add(std::move(mesh), Shading::smooth);
    return report_of(b.look({0, 0, 4}).scene(), 0);
  };
  const PlanReport min = report(32, 256, 0), finer = report(320, 256, 0), larger = report(32, 2560, 0),
                   rigged = report(32, 256, 50);
  EXPECT_GT(finer.milliseconds, min.milliseconds);
  EXPECT_GT(larger.milliseconds, min.milliseconds);
  EXPECT_EQ(larger.memory.pixels, 100 * min.memory.pixels);
  EXPECT_GT(find_note(rigged, "idle morph targets")->milliseconds, 0);

  const auto padded = [](std::size_t count) { return (count + 15) / 16 * 16; };
  for (const auto& [memory, segments, targets] :
       {std::tuple(min.memory, 32, 0), {finer.memory, 320, 0}, {rigged.memory, 32, 50}}) {
    const Mesh mesh = make_sphere({segments, segments / 2});
    const std::size_t vertices = padded(mesh.positions.size()), triangles = padded(mesh.triangles.size());
    EXPECT_EQ(memory.vertices, vertices * (16 + 16)) << "a record and a normal a vertex";
    EXPECT_EQ(memory.meshes, vertices * (6 + 3 * targets) * 4 + triangles * 3 * 4) << "targets as well, used or not";
  }
}

TEST(PlanReport, NamesFormAndBoundOfEveryObjectsVertices) {
  SceneBuilder b(640, 480);
  b.add(make_cube(), Shading::flat);
  b.add(make_grid({2, 2}), Shading::flat, place({0, -1.5, 0}, 1e6));
  Scene scene = b.look({0, 0, 5}).scene();
  EXPECT_EQ(find_note(report_of(scene, 0), "vertices of \"object 0\""), nullptr) << "no error is stated";
  scene.accuracy_pixels = 0.05;
  const PlanReport report = report_of(scene, 0);
  const PlanNote *cube = find_note(report, "vertices of \"object 0\""),
                 *ground = find_note(report, "vertices of \"object 1\"");
  ASSERT_TRUE(cube && ground);
  EXPECT_EQ(cube->reason.rfind("fp32: at most 0.00", 0), 0u) << cube->reason;
  EXPECT_EQ(ground->reason.rfind("two floats: at most 0.0", 0), 0u) << ground->reason;
  EXPECT_NE(ground->reason.find("fp32 relative to a pivot may be"), std::string::npos) << ground->reason;
  EXPECT_GT(ground->milliseconds, 0);
  scene.accuracy_pixels = 1e-3;
  EXPECT_NE(find_note(report_of(scene, 0), "vertices of \"object 0\"")->reason.find("warning: no form"),
            std::string::npos);
}

TEST(PlanReport, NamesADepthBufferThatIsNotTheDefault) {
  Scene scene = there_and_back();
  EXPECT_EQ(find_note(report_of(scene, 0), "depth buffer"), nullptr);
  scene.image.depth_format = DepthFormat::fixed24;
  EXPECT_EQ(find_note(report_of(scene, 0), "depth buffer")->reason, "fixed24 is asked for");
}

TEST(PlanReport, NamesTheRoundingOfDepthWithItsReason) {
  Scene scene = there_and_back();
  EXPECT_EQ(find_note(report_of(scene, 0), "rounding of Z"), nullptr);
  scene.image.z_error = 1e-6;
  const PlanReport rounds = report_of(scene, 0);
  ASSERT_NE(find_note(rounds, "rounding of Z"), nullptr);
  EXPECT_TRUE(find_note(rounds, "rounding of Z")->done);
  EXPECT_EQ(find_note(rounds, "rounding of Z")->reason,
            "z_error is 1e-06: 19 of 23 mantissa bits keep it, the others would fill files");
  scene.image.channels = every_channel;
  scene.image.p_error = 1e-4;
  scene.image.n_error = 1e-3;
  const PlanReport all = report_of(scene, 0);
  EXPECT_EQ(find_note(all, "rounding of P")->reason,
            "p_error is 0.0001: 13 of 23 mantissa bits keep it, the others would fill files");
  EXPECT_EQ(find_note(all, "rounding of N")->reason,
            "n_error is 0.001: multiples of 0.001953125 keep it, the bits below would fill files");
  scene.image.n_error = 1e-9;
  EXPECT_FALSE(find_note(report_of(scene, 0), "rounding of N")->done);
  scene.image.z_error = 1e-8;
  const PlanReport exact = report_of(scene, 0);
  EXPECT_FALSE(find_note(exact, "rounding of Z")->done);
  EXPECT_EQ(find_note(exact, "rounding of Z")->reason, "z_error is 1e-08: all 23 mantissa bits are needed");
}

TEST(PlanReport, SaysWhySeveralSamplesAreDrawnOrNot) {
  Scene scene = there_and_back();
  const PlanReport one = report_of(scene, 0);
  EXPECT_FALSE(find_note(one, "samples")->done);
  EXPECT_EQ(find_note(one, "pixel centres"), nullptr);
  scene.image.samples = 4;
  const PlanReport four = report_of(scene, 0);
  EXPECT_TRUE(find_note(four, "samples")->done);
  EXPECT_EQ(find_note(four, "samples")->reason, "4 a pixel are asked for: colour and alpha are their mean");
  EXPECT_GT(find_note(four, "samples")->milliseconds, 0);
  EXPECT_TRUE(find_note(four, "pixel centres")->done);
  EXPECT_GT(find_note(four, "pixel centres")->milliseconds, 0);
  EXPECT_GT(four.milliseconds, one.milliseconds);
  EXPECT_GT(four.memory.bins, one.memory.bins);
  scene.image.channels.erase(Channel::depth);
  const PlanReport colors = report_of(scene, 0);
  EXPECT_FALSE(find_note(colors, "pixel centres")->done);
  EXPECT_LT(colors.milliseconds, four.milliseconds);
  EXPECT_LT(colors.memory.bins, four.memory.bins);
  scene.image.channels.insert(Channel::depth);
  scene.image.channels.erase(Channel::color);
  const PlanReport distances = report_of(scene, 0);
  EXPECT_FALSE(find_note(distances, "samples")->done);
  EXPECT_EQ(find_note(distances, "samples")->reason, "4 a pixel are asked for, but no colour");
}

TEST(PlanReport, NamesEveryChannelWithItsBytes) {
  Scene scene = there_and_back();
  const PlanReport two = report_of(scene, 0);
  EXPECT_EQ(find_note(two, "RGBA")->reason, "asked for: 8 bytes a pixel");
  EXPECT_EQ(find_note(two, "Z")->reason, "asked for: 4 bytes a pixel");
  EXPECT_FALSE(find_note(two, "other channels")->done);
  EXPECT_EQ(
      find_note(two, "other channels")->reason,
      "N, P, velocity, uv, albedo, object_id, material_id, coverage, crypto_object, crypto_material: not among the "
      "channels");
  scene.image.channels = every_channel - ChannelSet{Channel::depth};
  const PlanReport others = report_of(scene, 0);
  EXPECT_FALSE(find_note(others, "Z")->done);
  EXPECT_EQ(find_note(others, "other channels"), nullptr);
  EXPECT_TRUE(find_note(others, "N")->done);
  EXPECT_TRUE(find_note(others, "N")->reason.starts_with("asked for: 6 bytes a pixel; of vertices on "));
  EXPECT_EQ(find_note(others, "crypto_object")->reason, "asked for: 48 bytes a pixel; of the pixel's centre alone");
  EXPECT_GT(others.memory.pixels, 10 * two.memory.pixels);
}

TEST(PlanReport, SaysWhichBufferIsTooLargeForADevice) {
  SceneBuilder b(64, 48);
  b.add(make_sphere({512, 256}), Shading::smooth);
  const MemoryNeed need = report_of(b.look({0, 0, 4}).scene(), 0).memory;
  EXPECT_EQ(exceeded_limit(need, need.largest_buffer), "");
  const std::string text = exceeded_limit(need, std::size_t{1} << 20);
  EXPECT_NE(text.find(need.largest_name), std::string::npos) << text;
  EXPECT_NE(text.find("the device allocates at most 1.0 MiB"), std::string::npos) << text;
}

// A device gets the picture in pieces of any size.
TEST(PlanReport, PictureIsNeverTooLargeForADevice) {
  SceneBuilder b(16384, 16384);
  b.add(make_cube(), Shading::flat);
  const MemoryNeed need = report_of(b.look({0, 0, 4}).scene(), 0).memory;
  EXPECT_EQ(need.pixels, std::size_t{16384} * 16384 * 12);
  EXPECT_EQ(exceeded_limit(need, std::size_t{1} << 30), "");
}

}  // namespace
}  // namespace morphcl::test
