// What the plan leaves out, and that it leaves out nothing that shows.
#include <gtest/gtest.h>

#include "host/error.hpp"
#include "host/geometry/solids.hpp"
#include "host/render/plan/report.hpp"
#include "host/render/reference_renderer.hpp"
#include "tests/render/parity.hpp"
#include "tests/render/scene_builder.hpp"
#include "tests/render/test_scenes.hpp"

namespace morphcl::test {
namespace {

bool is_done(const Scene& scene, const std::string& item) {
  const Planner planner(scene);
  for (const PlanNote& note : explain(planner, scene, {}, 0).notes)
    if (note.item == item) return note.done;
  ADD_FAILURE() << "the plan does not speak of \"" << item << "\"";
  return false;
}

TEST(Plan, ObjectsOutOfViewAreLeftOut) {
  SceneBuilder b(64, 48);
  b.add(make_cube(), Shading::flat);
  b.add(make_cube(), Shading::flat, place({0, 0, 9}));     // behind the eye
  b.add(make_cube(), Shading::flat, place({20, 0, 0}));    // to the right
  b.add(make_cube(), Shading::flat, place({0, 0, -500}));  // behind the far plane
  const FramePlan plan = plan_frame(b.look({0, 0, 5}).scene(), 0);
  EXPECT_EQ(plan.draws.size(), 1u);
  EXPECT_FALSE(is_done(b.scene(), "objects out of view"));
}

// The same picture when the plan's judgement of what is out of view is taken away: every object is drawn by hand.
TEST(Plan, LeavingOutObjectsChangesNoPixel) {
  const auto renderer = make_reference_renderer();
  for (const TestScene& test : test_scenes(96, 64)) {
    SCOPED_TRACE(test.name);
    const FramePlan whole = plan_frame(test.scene, 0);
    FrameBuffer planned(96, 64, true, true), merged(96, 64, true, true);
    renderer->render(whole, planned);
    // One object with a box around everything is never left out; its draws are the whole scene's.
    FramePlan everything = whole;
    everything.draws.clear();
    for (std::size_t i = 0; i < test.scene.objects.size(); ++i) {
      Scene alone = test.scene;
      alone.objects = {test.scene.objects[i]};
      alone.timeline.weights = {test.scene.timeline.weights[i]};
      // A far corner in every direction keeps the box in view; it belongs to no triangle.
      Mesh& mesh = alone.meshes[alone.objects[0].mesh];
      const std::size_t vertices = mesh.positions.size();
      const auto widen = [&](const glm::vec3& corner) {
        mesh.positions.push_back(corner);
        if (!mesh.normals.empty()) mesh.normals.push_back({0, 0, 1});
        if (!mesh.colors.empty()) mesh.colors.push_back(glm::vec4(1));
        for (MorphTarget& target : mesh.targets) {
          if (!target.positions.empty())
            target.positions.push_back(target.form == TargetForm::absolute ? corner : glm::vec3(0));
          if (!target.normals.empty()) target.normals.push_back({0, 0, 1});
          if (!target.colors.empty()) target.colors.push_back(glm::vec4(0));
        }
      };
      widen(glm::vec3(-1e7f)), widen(glm::vec3(1e7f));
      FramePlan plan = plan_frame(alone, 0);
      for (Draw& draw : plan.draws) {
        draw.mesh = &test.scene.meshes[test.scene.objects[i].mesh];
        EXPECT_EQ(draw.mesh->positions.size(), vertices);
        everything.draws.push_back(draw);
      }
    }
    EXPECT_GE(everything.draws.size(), whole.draws.size());
    renderer->render(everything, merged);
    EXPECT_TRUE(same_pixels(merged, planned));
  }
}

TEST(Plan, TargetsOfWeightZeroAreNotActive) {
  SceneBuilder b(64, 48);
  Mesh mesh = make_cube();
  for (int t = 0; t < 5; ++t)
    mesh.targets.push_back({"target", TargetForm::delta, std::vector<glm::vec3>(24, glm::vec3(0.1f)), {}, {}});
  b.add(mesh, Shading::flat);
  const FramePlan plan = plan_frame(b.look({0, 0, 5}).weight(0, 0.5, 3).scene(), 0);
  ASSERT_EQ(plan.draws.size(), 1u);
  ASSERT_EQ(plan.draws[0].targets.size(), 1u);
  EXPECT_EQ(plan.draws[0].targets[0].target, 3);
  EXPECT_FALSE(is_done(b.scene(), "idle morph targets"));
}

TEST(Plan, WithoutLightsNormalsAreNotMoved) {
  SceneBuilder b(64, 48);
  b.add(make_sphere({16, 8}), Shading::smooth);
  b.look({0, 0, 5}).no_lights();
  const FramePlan plan = plan_frame(b.scene(), 0);
  EXPECT_FALSE(is_done(b.scene(), "vertex normals"));
  EXPECT_FALSE(is_done(b.scene(), "lights"));
  EXPECT_EQ(plan.draws.at(0).shading, Shading::unlit);
}

TEST(Plan, ClippingIsLeftOutAwayFromThePlanes) {
  SceneBuilder b(64, 48);
  b.add(make_cube(), Shading::flat);
  EXPECT_FALSE(is_done(b.look({0, 0, 5}).scene(), "clipping"));
  EXPECT_TRUE(is_done(b.look({0, 0, 1.05}).scene(), "clipping"));
}

TEST(Plan, HiddenObjectsAreLeftOut) {
  SceneBuilder b(64, 48);
  b.add(make_cube(), Shading::flat);
  Timeline& timeline = b.look({0, 0, 5}).scene().timeline;
  timeline.nodes[0].visible_track = Track(Interpolation::step, 1, false, timeline.time.ticks_per_second(),
                                          {0, timeline.time.frame_ticks(10)}, {0.0, 1.0});
  EXPECT_EQ(plan_frame(b.scene(), 9).draws.size(), 0u);
  EXPECT_EQ(plan_frame(b.scene(), 10).draws.size(), 1u);
}

TEST(Plan, ATransformThatLeavesSinglePrecisionIsNamed) {
  SceneBuilder b(64, 48);
  b.add(make_cube(), Shading::flat, place({0, 0, 0}, 1e39));
  try {
    plan_frame(b.look({0, 0, 5}).scene(), 12);
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::bad_input);
    EXPECT_NE(std::string(error.what()).find("frame 12: object \"object 0\""), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace morphcl::test
