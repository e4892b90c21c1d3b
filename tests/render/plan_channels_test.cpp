// What plans hold for channels beside colour and distance: only what they ask for, and what reports say about it.
#include <gtest/gtest.h>

#include <algorithm>

#include "host/render/frame/frame_plan.hpp"
#include "morphcl/explain.hpp"
#include "morphcl/planner.hpp"
#include "morphcl/solids.hpp"
#include "tests/render/channel_scenes.hpp"

namespace morphcl::test {
namespace {

// A smooth, a flat and an unlit body, the last without normals, and lines. The second drifts.
Scene four_objects(ChannelSet channels) {
  SceneBuilder b(60, 40);
  Mesh bare = make_cube();
  bare.normals.clear();
  b.add(make_cube(), Shading::smooth, place({-1.5, 0, 0}, 0.4));
  b.add(make_cube(), Shading::flat, place({-0.5, 0, 0}, 0.4));
  b.add(bare, Shading::unlit, place({0.5, 0, 0}, 0.4));
  b.add(make_cube(), Shading::wireframe, place({1.5, 0, 0}, 0.4));
  Scene& scene = b.look({0, 1, 5}).scene();
  scene.timeline.nodes[1].translation_track = drifting(scene.timeline.time, {0, 0, 0}, {1, 0, 0});
  scene.image.channels = channels;
  return scene;
}

TEST(PlanChannels, HoldNothingThatIsNotAskedFor) {
  const Scene scene = four_objects(default_channels);
  const Plan plan = plan_frame(scene, 0);
  EXPECT_TRUE(plan->next_draws.empty());
  for (const Draw& draw : plan->draws) {
    EXPECT_EQ(draw.normals, NormalSource::none);
    EXPECT_FALSE(draw.moves);
    EXPECT_EQ(draw.albedo, (std::array<float, 3>{}));
  }
}

TEST(PlanChannels, NormalsComeAsShadingHasThemThoughNothingIsLit) {
  for (const ChannelSet channels : {ChannelSet{Channel::normal}, ChannelSet{Channel::normal, Channel::color}}) {
    Scene scene = four_objects(channels);
    scene.timeline.lights.clear();
    const Plan plan = plan_frame(scene, 0);
    ASSERT_EQ(plan->draws.size(), 4u);
    EXPECT_EQ(plan->draws[0].normals, NormalSource::vertices);
    EXPECT_EQ(plan->draws[1].normals, NormalSource::faces);
    EXPECT_EQ(plan->draws[2].normals, NormalSource::faces);
    EXPECT_EQ(plan->draws[3].normals, NormalSource::none);
    for (int i = 0; i < 3; ++i) EXPECT_NE(plan->draws[static_cast<std::size_t>(i)].normal_to_eye[0][0], 0.0f);
  }
}

TEST(PlanChannels, VelocityLooksAtTheNextNumber) {
  const Scene scene = four_objects({Channel::velocity});
  const Planner planner(scene);
  for (const std::int64_t frame : {0, 40, 99, 100}) {
    const Plan plan = planner.plan(frame), after = planner.plan(frame + 1);
    ASSERT_EQ(plan->next_draws.size(), plan->draws.size());
    for (std::size_t i = 0; i < plan->draws.size(); ++i) {
      EXPECT_EQ(plan->next_draws[i].object_to_clip, after->draws[i].object_to_clip);
      EXPECT_EQ(plan->draws[i].moves, i == 1 && frame < 100) << i << " in frame " << frame;
    }
  }
}

TEST(PlanChannels, EverythingMovesUnderACameraThatMoves) {
  Scene scene = four_objects({Channel::velocity});
  scene.timeline.camera.eye_track = drifting(scene.timeline.time, scene.timeline.camera.eye, {1, 0, 0});
  const Plan plan = plan_frame(scene, 5);
  for (const Draw& draw : plan->draws) EXPECT_TRUE(draw.moves);
}

TEST(PlanChannels, SamplesAreDrawnForWhatDependsOnThem) {
  const auto samples = [](ChannelSet channels) {
    Scene scene = four_objects(channels);
    scene.image.samples = 8;
    const Plan plan = plan_frame(scene, 0);
    return plan->samples;
  };
  EXPECT_EQ(samples({Channel::depth, Channel::normal, Channel::object_id, Channel::velocity}), 1);
  for (const Channel channel : {Channel::color, Channel::coverage, Channel::crypto_object, Channel::crypto_material})
    EXPECT_EQ(samples({Channel::depth, channel}), 8) << name_of(channel);
}

const PlanNote* note_of(const PlanReport& report, std::string_view item) {
  const auto found =
      std::find_if(report.notes.begin(), report.notes.end(), [&](const PlanNote& note) { return note.item == item; });
  return found == report.notes.end() ? nullptr : &*found;
}

TEST(PlanChannels, ReportsSayWhatEachCosts) {
  const Scene few = four_objects(default_channels), every = four_objects(every_channel);
  const Planner planner_of_few(few), planner_of_all(every);
  const PlanReport two = explain(planner_of_few, 0), report = explain(planner_of_all, 0);
  for (const Channel channel : every_channel) {
    const PlanNote* const note = note_of(report, name_of(channel));
    ASSERT_NE(note, nullptr) << name_of(channel);
    EXPECT_TRUE(note->done) << name_of(channel);
    EXPECT_GT(note->milliseconds, 0) << name_of(channel);
  }
  EXPECT_NE(note_of(report, "N")->reason.find("of vertices on 1 of 4 objects, of faces on 2 of 4"), std::string::npos);
  EXPECT_NE(note_of(report, "velocity")->reason.find("1 of 4 objects will be elsewhere"), std::string::npos);
  EXPECT_GT(note_of(report, "ids of what is seen")->milliseconds, 0);
  EXPECT_TRUE(note_of(report, "next frame's vertices")->done);
  EXPECT_EQ(note_of(two, "ids of what is seen"), nullptr);
  EXPECT_GT(report.milliseconds, two.milliseconds);
}

}  // namespace
}  // namespace morphcl::test
