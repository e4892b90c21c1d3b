// Plans that say that they have the draws of an earlier one have them.
#include <gtest/gtest.h>

#include "host/render/frame/frame_plan.hpp"
#include "morphcl/error.hpp"
#include "morphcl/planner.hpp"
#include "morphcl/solids.hpp"
#include "tests/render/scene_builder.hpp"

namespace morphcl::test {
namespace {

Track keys(const Timeline& timeline, Interpolation interpolation, int width, const std::vector<double>& values) {
  std::vector<std::int64_t> ticks;
  for (std::size_t frame = 0; frame * width < values.size(); ++frame)
    ticks.push_back(timeline.time.frame_ticks(static_cast<std::int64_t>(frame)));
  return Track({interpolation, width, false, timeline.time.ticks_per_second(), ticks, values});
}

// Pyramids in a row, the last ones partly out of view.
Scene row_of_pyramids() {
  SceneBuilder builder(160, 90);
  for (int i = 0; i < 12; ++i)
    builder.add(make_pyramid_to_cube(), Shading::flat, place({i - 6.0, 0, 0}, 0.008) * place({-100, -100, -65}));
  builder.look({0, 1, 5});
  return builder.scene();
}

std::vector<std::uint64_t> versions(const Scene& scene, const std::vector<std::int64_t>& frames) {
  const Planner planner(scene);
  std::vector<std::uint64_t> found;
  for (const std::int64_t frame : frames) {
    found.push_back((*planner.plan(frame)).draws_version);
    EXPECT_NE(found.back(), 0u);
  }
  return found;
}

TEST(DrawsVersion, StaysWhereOnlyWeightsMove) {
  Scene scene = row_of_pyramids();
  for (Object& object : scene.objects)
    object.morph.tracks.push_back({0, keys(scene.timeline, Interpolation::linear, 1, {0.1, 1})});
  const auto found = versions(scene, {0, 1, 0});
  EXPECT_EQ(found[0], found[1]);
  EXPECT_EQ(found[1], found[2]);
}

TEST(DrawsVersion, IsAnotherOneWhenATargetComesOrGoes) {
  Scene scene = row_of_pyramids();
  scene.objects[5].morph.tracks.push_back({0, keys(scene.timeline, Interpolation::step, 1, {0.5, 0, 0, 0.5})});
  const auto found = versions(scene, {0, 1, 2, 3});
  EXPECT_NE(found[0], found[1]);
  EXPECT_EQ(found[1], found[2]);
  EXPECT_NE(found[2], found[3]);
}

// A pyramid stands far aside and reaches the view only by its target.
TEST(DrawsVersion, StaysWhileAnObjectThatMayComeIntoViewIsOutOfIt) {
  Scene scene = row_of_pyramids();
  constexpr std::size_t aside = 5;
  Mesh& mesh = scene.meshes[static_cast<std::size_t>(scene.objects[aside].mesh)];
  for (glm::vec3& position : mesh.positions) position.x += 1e5f;
  scene.objects[aside].morph.tracks.push_back({0, keys(scene.timeline, Interpolation::linear, 1, {0, 0.25, 0.25, 1})});
  const Planner planner(scene);
  std::vector<Plan> plans;
  for (const std::int64_t frame : {0, 1, 2, 3}) plans.push_back(planner.plan(frame));
  EXPECT_EQ(plans[1]->draws.size() + 1, plans[3]->draws.size());
  EXPECT_EQ(plans[0]->draws_version, plans[1]->draws_version);
  EXPECT_EQ(plans[1]->draws_version, plans[2]->draws_version);
  EXPECT_NE(plans[2]->draws_version, plans[3]->draws_version);
}

TEST(DrawsVersion, IsAnotherOneWhenAnObjectMovesOrHidesOrTheCameraMoves) {
  const Scene still = row_of_pyramids();
  const Timeline& timeline = still.timeline;
  Scene moving = still, hiding = still, looking = still;
  moving.timeline.nodes[5].translation_track = keys(timeline, Interpolation::step, 3, {0, 0, 0, 0, 0.1, 0});
  hiding.timeline.nodes[5].visible_track = keys(timeline, Interpolation::step, 1, {1, 0});
  looking.timeline.camera.eye_track = keys(timeline, Interpolation::step, 3, {0, 1, 5, 0.25, 1, 5});
  for (const Scene& scene : {moving, hiding, looking}) {
    const auto found = versions(scene, {0, 1, 0});
    EXPECT_NE(found[0], found[1]);
    EXPECT_NE(found[1], found[2]);
  }
}

// Objects of one mesh that morph alike share what is evaluated; neighbours that do not are told apart.
TEST(SharedWeights, AreThoseOfTheObject) {
  Scene scene = row_of_pyramids();
  for (Object& object : scene.objects) object.mesh = 0;
  Timeline& timeline = scene.timeline;
  const double ends[] = {1, 1, 0.5, 0.5, 1, 0.25, 0.25, 0.25, 1, 1, 1, 0.75};
  for (std::size_t i = 0; i < scene.objects.size(); ++i)
    scene.objects[i].morph.tracks.push_back({0, keys(timeline, Interpolation::linear, 1, {0.125, ends[i]})});
  const Planner planner(scene);
  for (const std::int64_t frame : {1, 0, 1})
    for (const Draw& draw : (*planner.plan(frame)).draws)
      EXPECT_EQ(draw.targets[0].weight, frame == 0 ? 0.125f : static_cast<float>(ends[draw.object])) << draw.object;
}

TEST(SharedWeights, ThatOverflowAreAnErrorEachTime) {
  Scene scene = row_of_pyramids();
  constexpr double huge = 1e308;
  scene.objects[5].morph.tracks.push_back({0, Track({Interpolation::cubic,
                                                     1,
                                                     false,
                                                     scene.timeline.time.ticks_per_second(),
                                                     {0, scene.timeline.time.frame_ticks(1000)},
                                                     {0, 0, huge, -huge, 0, 0}})});
  const Planner planner(scene);
  for (int i = 0; i < 2; ++i) EXPECT_THROW(planner.plan(500), Error);
}

}  // namespace
}  // namespace morphcl::test
