// Elastic objects through the renderers: the same bits on device and reference, and in whatever order frames are asked
// for.
#include <cmath>
#include <set>

#include "host/geometry/welded_mesh.hpp"
#include "host/render/frame/frame_plan.hpp"
#include "host/render/frame/plan_digest.hpp"
#include "host/scene/model/elastic_object.hpp"
#include "morphcl/error.hpp"
#include "morphcl/explain.hpp"
#include "morphcl/renderer.hpp"
#include "morphcl/solids.hpp"
#include "tests/render/parity.hpp"
#include "tests/render/scene_builder.hpp"
#include "tests/render/shared_session.hpp"

namespace morphcl::test {
namespace {

constexpr int elastic_width = 240, elastic_height = 160;

// From 0 to 1 within 6 frames, then held.
Track growing(const Timeline& timeline) {
  return Track({Interpolation::linear,
                1,
                false,
                timeline.time.ticks_per_second(),
                {timeline.time.frame_ticks(2), timeline.time.frame_ticks(8)},
                {0, 1}});
}

Elastic soft(double stiffness) {
  Elastic elastic;
  elastic.anchor = 500;
  elastic.stiffness = stiffness;
  elastic.damping = 3;
  return elastic;
}

// A pyramid in modes, a sphere in steps, and a cube that stands still between them.
Scene elastic_scene(Shading shading) {
  SceneBuilder builder(elastic_width, elastic_height);
  builder.look({0.5, 1.5, 5});
  builder.add(make_pyramid_to_cube(), shading, place({-1.3, -0.4, 0}, 0.012) * place({-100, -100, -65}));
  builder.add(make_cube(), shading, place({0, -0.9, 0}, 0.3), {0.9, 0.3, 0.3, 1});
  builder.add(make_sphere_to_cube({24, 16}), shading, place({1.2, 0, 0}, 0.6), {0.2, 0.6, 0.9, 1});
  Scene& scene = builder.scene();
  for (const std::size_t object : {0, 2}) {
    scene.objects[object].morph.tracks.push_back({0, growing(scene.timeline)});
    scene.objects[object].morph.elastic = soft(object == 0 ? 3000 : 9000);
  }
  scene.frames = {{0, 60, 1}};
  validate(scene);
  return scene;
}

FrameBuffer drawn(Renderer& renderer, const Plan& plan) {
  FrameBuffer pixels(plan->width, plan->height, plan->channels);
  renderer.render(plan, pixels);
  return pixels;
}

class ElasticObjects : public ::testing::TestWithParam<Shading> {};

TEST_P(ElasticObjects, DeviceEqualsReferenceInAnyOrder) {
  const Scene scene = elastic_scene(GetParam());
  const Planner planner(scene);
  const auto device = make_device_renderer(shared_session()), reference = make_reference_renderer();
  FrameBuffer kept(elastic_width, elastic_height, {Channel::color, Channel::depth});
  for (const std::int64_t frame : {0, 5, 6, 7, 7, 30, 12, 57, 0, 8}) {
    const Plan plan = planner.plan(frame);
    ASSERT_EQ(plan->draws.size(), 3u);
    device->render(plan, kept);
    EXPECT_TRUE(same_pixels(drawn(*reference, plan), kept)) << "frame " << frame;
  }
}

TEST_P(ElasticObjects, Frame57AloneIsThatOfTheWholeSequence) {
  const Scene scene = elastic_scene(GetParam());
  const Planner whole(scene), alone(scene);
  const auto device = make_device_renderer(shared_session());
  for (std::int64_t frame = 0; frame < 57; ++frame) drawn(*device, whole.plan(frame));
  const FrameBuffer last = drawn(*device, whole.plan(57));
  const auto fresh = make_device_renderer(shared_session());
  EXPECT_TRUE(same_pixels(last, drawn(*fresh, alone.plan(57))));
  EXPECT_EQ(pixel_digest(*whole.plan(57)), pixel_digest(*whole.plan(57)));
}

INSTANTIATE_TEST_SUITE_P(Shadings, ElasticObjects,
                         ::testing::Values(Shading::flat, Shading::smooth, Shading::wireframe, Shading::unlit));

TEST(ElasticObject, TwoOfOneMeshMoveEachOnItsOwn) {
  SceneBuilder builder(elastic_width, elastic_height);
  builder.look({0, 0, 6});
  builder.add(make_sphere_to_cube({12, 8}), Shading::smooth, place({-1.5, 0, 0}));
  Scene scene = builder.scene();
  scene.objects.push_back(scene.objects[0]);
  scene.objects[1].node = 1;
  scene.timeline.nodes.push_back(scene.timeline.nodes[0]);
  scene.timeline.nodes[1].static_transform = place({1.5, 0, 0});
  for (const std::size_t object : {0, 1}) {
    scene.objects[object].morph.tracks.push_back({0, growing(scene.timeline)});
    scene.objects[object].morph.elastic = soft(object == 0 ? 10 : 1e5);
  }
  validate(scene);
  const Planner planner(scene);
  const auto device = make_device_renderer(shared_session()), reference = make_reference_renderer();
  for (const std::int64_t frame : {4, 9, 10}) {
    const Plan plan = planner.plan(frame);
    EXPECT_NE(plan->draws[0].displaced->hash, plan->draws[1].displaced->hash);
    EXPECT_TRUE(same_pixels(drawn(*reference, plan), drawn(*device, plan))) << frame;
  }
}

TEST(ElasticObject, ArriveAtTheirTargets) {
  const Scene scene = elastic_scene(Shading::flat);
  const Planner planner(scene);
  for (const std::size_t draw : {0, 2}) {
    const Plan moving = planner.plan(8), rested = planner.plan(600);
    const Mesh& mesh = *rested->draws[draw].mesh;
    double off = 0;
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
      off = std::max(off,
                     double{glm::length(moving->draws[draw].displaced->positions[i] - mesh.targets[0].positions[i])});
      for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(rested->draws[draw].displaced->positions[i][c], mesh.targets[0].positions[i][c],
                    1e-6 * (1 + std::abs(mesh.targets[0].positions[i][c])));
    }
    EXPECT_GT(off, draw == 0 ? 1 : 0.01) << "it lags while the morph moves";
  }
}

TEST(ElasticObject, RestInTheMeshItselfBeforeTheFirstKey) {
  const Scene scene = elastic_scene(Shading::flat);
  const Plan plan = plan_frame(scene, 2);
  EXPECT_EQ(plan->draws[0].displaced->positions, scene.meshes[0].positions);
  EXPECT_EQ(plan->draws[2].displaced->positions, scene.meshes[2].positions);
}

// Its weights keep the object below the picture; its springs throw it into it.
TEST(ElasticObject, AreSeenWhereTheirSpringsThrowThem) {
  SceneBuilder builder(elastic_width, elastic_height);
  builder.look({0, 0, 4});
  Mesh mesh = make_cube();
  MorphTarget lifted;
  lifted.name = "lifted";
  lifted.form = TargetForm::delta;
  lifted.positions.assign(mesh.positions.size(), glm::vec3(0, 5, 0));
  mesh.targets = {lifted};
  builder.add(mesh, Shading::flat, place({0, -4.6, 0}, 0.3));
  Scene& scene = builder.scene();
  scene.objects[0].morph.tracks.push_back(
      {0, Track({Interpolation::step, 1, false, scene.timeline.time.ticks_per_second(), {0, 1}, {0, 1}})});
  std::set<bool> seen;
  for (const bool elastic : {false, true}) {
    if (elastic) scene.objects[0].morph.elastic = Elastic{.anchor = 60, .stiffness = 500, .damping = 0.5};
    const Planner planner(scene), careful(scene, {.leave_out = false});
    const auto device = make_device_renderer(shared_session());
    bool ever = false;
    for (std::int64_t frame = 0; frame < 30; ++frame) {
      const FrameBuffer pixels = drawn(*device, planner.plan(frame));
      device->forget();
      EXPECT_TRUE(same_pixels(drawn(*device, careful.plan(frame)), pixels)) << frame;
      device->forget();
      ever |= covered_pixels(pixels) > 0;
    }
    EXPECT_EQ(ever, elastic);
  }
}

TEST(ElasticObject, PlansSayHowTheyAreMoved) {
  const Scene scene = elastic_scene(Shading::flat);
  const Planner planner(scene);
  const PlanReport report = explain(planner, 7);
  std::string found;
  for (const PlanNote& note : report.notes)
    if (note.item == "elastic vertices") {
      found = note.reason;
      EXPECT_TRUE(note.done);
      EXPECT_GT(note.milliseconds, 0);
    }
  const std::size_t points = weld(scene.meshes[2]).vertex_of_point.size();
  EXPECT_EQ(found,
            "2 objects, " + std::to_string(8 + points) + " points: 1 mode by mode, the others in steps of TR-BDF2");
  EXPECT_GT(points, 256u);
}

TEST(ElasticObject, StiffEdgesOfAnyRatioStayFinite) {
  SceneBuilder builder(elastic_width, elastic_height);
  builder.add(make_sphere_to_cube({24, 16}), Shading::flat, glm::dmat4(1.0));
  Scene& scene = builder.scene();
  scene.objects[0].morph.tracks.push_back({0, growing(scene.timeline)});
  scene.objects[0].morph.elastic =
      Elastic{.anchor = 1, .stiffness = 1e12, .damping = 0.1, .rule = EdgeStiffness::by_length};
  const Planner planner(scene);
  for (const std::int64_t frame : {3, 8, 40, 100}) {
    const Box& box = (*planner.plan(frame)).draws[0].displaced->box;
    for (int c = 0; c < 3; ++c) {
      EXPECT_GT(box.lower[c], -3) << frame;
      EXPECT_LT(box.upper[c], 3) << frame;
    }
  }
}

TEST(ElasticObject, AMotionThatOverflowsNamesItsObject) {
  Scene scene = elastic_scene(Shading::flat);
  scene.objects[0].morph.tracks[0].track =
      Track({Interpolation::linear, 1, false, scene.timeline.time.ticks_per_second(), {0, 1}, {0, 1e300}});
  try {
    plan_frame(scene, 3);
    ADD_FAILURE() << "nothing was thrown";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::bad_input);
    EXPECT_NE(std::string(error.what()).find("object \""), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace morphcl::test
