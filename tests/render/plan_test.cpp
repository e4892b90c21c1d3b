// What the plan leaves out, and what it says about it.
#include <gtest/gtest.h>

#include "host/render/frame/frame_plan.hpp"
#include "morphcl/error.hpp"
#include "morphcl/explain.hpp"
#include "morphcl/solids.hpp"
#include "tests/render/scene_builder.hpp"

namespace morphcl::test {
namespace {

bool is_done(const Scene& scene, const std::string& item) {
  const Planner planner(scene);
  for (const PlanNote& note : explain(planner, 0).notes)
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
  const Plan plan = plan_frame(b.look({0, 0, 5}).scene(), 0);
  EXPECT_EQ(plan->draws.size(), 1u);
  EXPECT_FALSE(is_done(b.scene(), "objects out of view"));
}

TEST(Plan, TargetsOfWeightZeroAreNotActive) {
  SceneBuilder b(64, 48);
  Mesh mesh = make_cube();
  for (int t = 0; t < 5; ++t)
    mesh.targets.push_back({"target", TargetForm::delta, std::vector<glm::vec3>(24, glm::vec3(0.1f)), {}, {}});
  b.add(mesh, Shading::flat);
  const Plan plan = plan_frame(b.look({0, 0, 5}).weight(0, 0.5, 3).scene(), 0);
  ASSERT_EQ(plan->draws.size(), 1u);
  ASSERT_EQ(plan->draws[0].targets.size(), 1u);
  EXPECT_EQ(plan->draws[0].targets[0].target, 3);
  EXPECT_FALSE(is_done(b.scene(), "idle morph targets"));
}

TEST(Plan, WithoutLightsNormalsAreNotMoved) {
  SceneBuilder b(64, 48);
  b.add(make_sphere({16, 8}), Shading::smooth);
  b.look({0, 0, 5}).no_lights();
  const Plan plan = plan_frame(b.scene(), 0);
  EXPECT_FALSE(is_done(b.scene(), "vertex normals"));
  EXPECT_FALSE(is_done(b.scene(), "lights"));
  EXPECT_EQ(plan->draws.at(0).shading, Shading::unlit);
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
  timeline.nodes[0].visible_track = Track({Interpolation::step,
                                           1,
                                           false,
                                           timeline.time.ticks_per_second(),
                                           {0, timeline.time.frame_ticks(10)},
                                           {0.0, 1.0}});
  EXPECT_EQ((*plan_frame(b.scene(), 9)).draws.size(), 0u);
  EXPECT_EQ((*plan_frame(b.scene(), 10)).draws.size(), 1u);
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
