// Whatever a plan leaves out, the picture is the same: on the reference and on the device, item by item and all at
// once.
#include <gtest/gtest.h>

#include "host/render/frame/frame_plan.hpp"
#include "morphcl/planner.hpp"
#include "morphcl/renderer.hpp"
#include "morphcl/solids.hpp"
#include "tests/render/parity.hpp"
#include "tests/render/scene_builder.hpp"
#include "tests/render/shared_session.hpp"
#include "tests/render/test_scenes.hpp"

namespace morphcl::test {
namespace {

constexpr int leave_out_width = 150, leave_out_height = 90;

struct Choice {
  const char* name;
  PlanOptions options;
};

const Choice choices[] = {
    {"nothing is left out", {.leave_out = false}},
    {"objects out of view are drawn", {.objects_out_of_view = false}},
    {"targets of weight 0 are applied", {.idle_targets = false}},
    {"normals are carried", {.normals = false}},
    {"everything may be clipped", {.clipping = false}},
    {"everything is divided by w", {.divide = false}},
    {"depths are compared", {.depth_test = false}},
    {"vertices are projected again", {.kept_vertices = false}},
    {"blank tiles are written again", {.blank_tiles = false}},
};

FrameBuffer draw(Renderer& renderer, const Planner& planner, std::int64_t frame) {
  const Plan plan = planner.plan(frame);
  FrameBuffer pixels = plan.make_frame();
  renderer.forget();  // planners take turns here
  renderer.render(plan, pixels);
  return pixels;
}

TEST(LeaveOut, OnTheReferenceNoPixelChanges) {
  const auto renderer = make_reference_renderer();
  for (const TestScene& test : test_scenes(leave_out_width, leave_out_height)) {
    const Planner usual(test.scene), nothing_left_out(test.scene, choices[0].options);
    for (const std::int64_t frame : test.frames) {
      const FrameBuffer expected = draw(*renderer, usual, frame), actual = draw(*renderer, nothing_left_out, frame);
      EXPECT_TRUE(same_pixels(expected, actual)) << test.name << ", frame " << frame;
    }
  }
}

// Distances alone need no colours, normals or lights.
TEST(LeaveOut, WithoutColourNoDistanceChanges) {
  const auto device = make_device_renderer(shared_session()), reference = make_reference_renderer();
  for (TestScene& test : test_scenes(leave_out_width, leave_out_height)) {
    test.scene.image.channels.erase(Channel::color);
    const Planner usual(test.scene), nothing_left_out(test.scene, choices[0].options);
    for (const Draw& one : (*usual.plan(0)).draws) {
      EXPECT_TRUE(one.shading == Shading::unlit || one.shading == Shading::wireframe) << test.name;
      EXPECT_FALSE(one.vertex_colors) << test.name;
    }
    const FrameBuffer expected = draw(*reference, nothing_left_out, 0);
    EXPECT_TRUE(same_pixels(expected, draw(*reference, usual, 0))) << test.name;
    EXPECT_TRUE(same_pixels(expected, draw(*device, usual, 0))) << test.name;
    EXPECT_TRUE(same_pixels(expected, draw(*device, nothing_left_out, 0))) << test.name;
  }
}

TEST(LeaveOut, OnTheDeviceNoPixelChanges) {
  const auto renderer = make_device_renderer(shared_session());
  for (const TestScene& test : test_scenes(leave_out_width, leave_out_height)) {
    const Planner usual(test.scene);
    for (const Choice& choice : choices) {
      SCOPED_TRACE(test.name + ": " + choice.name);
      const Planner planner(test.scene, choice.options);
      for (const std::int64_t frame : test.frames) {
        const FrameBuffer expected = draw(*renderer, usual, frame), actual = draw(*renderer, planner, frame);
        EXPECT_TRUE(same_pixels(expected, actual)) << "frame " << frame;
      }
    }
  }
}

// The test scenes give every item something to leave out; else the tests above would compare a plan with itself.
TEST(LeaveOut, EveryItemIsLeftOutSomewhere) {
  bool objects = false, targets = false, normals = false, clipping = false, divide = false, depth_test = false;
  for (const TestScene& test : test_scenes(leave_out_width, leave_out_height)) {
    const Plan usual = plan_frame(test.scene, 0), whole = plan_frame(test.scene, 0, {.leave_out = false});
    EXPECT_TRUE(whole->clips && whole->divides && whole->tests_depth) << test.name;
    EXPECT_FALSE(whole->keeps_vertices || whole->keeps_blank_tiles) << test.name;
    EXPECT_TRUE(usual->keeps_vertices && usual->keeps_blank_tiles) << test.name;
    objects |= usual->draws.size() < whole->draws.size();
    clipping |= !usual->clips;
    divide |= !usual->divides;
    depth_test |= !usual->tests_depth;
    for (const Draw& draw : whole->draws) {
      EXPECT_EQ(draw.targets.size(), draw.mesh->targets.size()) << test.name;
      for (const ActiveTarget& target : draw.targets) targets |= target.weight == 0.0f;
    }
    for (std::size_t i = 0; i < usual->draws.size() && usual->draws.size() == whole->draws.size(); ++i)
      normals |= usual->draws[i].shading != whole->draws[i].shading;
  }
  EXPECT_TRUE(objects && targets && normals && clipping && divide && depth_test)
      << objects << targets << normals << clipping << divide << depth_test;
}

// Coordinates that cancel in single precision: what binary64 sees just outside may be drawn just inside.
TEST(LeaveOut, ObjectsWhoseCoordinatesCancelAreJudgedWithTheirRounding) {
  const auto renderer = make_reference_renderer();
  constexpr double far_away = 4e6;
  int drawn = 0, blank = 0;
  for (int trial = 0; trial < 120; ++trial) {
    const double fovy = 40 + 0.37 * trial, side = trial % 2 ? 1 : -1;
    const double edge = 5 * std::tan(glm::radians(fovy / 2)) * 64 / 48;  // of the view, where z = 0
    Mesh mesh = make_cube();
    for (glm::vec3& p : mesh.positions) p += glm::vec3(far_away, 0, 0);
    SceneBuilder b(64, 48);
    // The view reaches to 1.2 of that at the cube's far side, z = -1.
    b.add(mesh, Shading::flat, place({-far_away + side * (1.2 * edge + 1 + 0.01 * (trial % 31 - 15)), 0, 0}));
    b.look({0, 0, 5}).project(Perspective{fovy, 0.1, 100});
    const Planner usual(b.scene()), nothing_left_out(b.scene(), {.leave_out = false});
    const FrameBuffer expected = draw(*renderer, nothing_left_out, 0), actual = draw(*renderer, usual, 0);
    EXPECT_TRUE(same_pixels(expected, actual)) << "trial " << trial;
    (covered_pixels(expected) > 0 ? drawn : blank) += 1;
  }
  EXPECT_GT(drawn, 10);
  EXPECT_GT(blank, 10);
}

// The near plane's distance is rounded to fp32, up or down, and what lies on it is in front of it.
TEST(LeaveOut, WhatLiesOnTheNearPlaneIsDrawn) {
  const auto renderer = make_reference_renderer();
  for (const double near : {0.1, 0.2, 0.3, 0.4, 0.7, 1.3}) {
    SceneBuilder b(64, 48);
    Mesh mesh;
    mesh.positions = {{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}};
    mesh.triangles = {{0, 1, 2}};
    b.add(mesh, Shading::flat, place({0, 0, -near}));
    b.look({0, 0, 0}, {0, 0, -1}).project(Perspective{45, near, 100});
    EXPECT_GT(covered_pixels(draw(*renderer, Planner(b.scene()), 0)), 0u) << "near " << near;
  }
}

// Beyond 1e33 a vertex counts as invalid and its triangles are not drawn: by every renderer, so it is never skipped.
TEST(LeaveOut, ClippingIsNotLeftOutWhereCoordinatesAreInvalid) {
  SceneBuilder b(64, 48);
  b.add(make_cube(), Shading::flat, place({0, 0, -5e34}, 1e34));
  b.look({0, 0, 5}).project(Perspective{45, 0.1, std::numeric_limits<double>::infinity()});
  EXPECT_TRUE((*plan_frame(b.scene(), 0)).clips);
  const auto device = make_device_renderer(shared_session()), reference = make_reference_renderer();
  const Planner planner(b.scene());
  EXPECT_TRUE(same_pixels(draw(*reference, planner, 0), draw(*device, planner, 0)));
}

}  // namespace
}  // namespace morphcl::test
