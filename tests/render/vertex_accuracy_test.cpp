// Where vertices land on the screen: each form within its bound of exact arithmetic, the cheapest that keeps the stated
// error chosen, the same bits on device and reference.
#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <random>

#include "host/render/frame/frame_plan.hpp"
#include "host/render/frame/scene_vertices.hpp"
#include "host/render/plan/view_volume.hpp"
#include "morphcl/planner.hpp"
#include "morphcl/renderer.hpp"
#include "morphcl/solids.hpp"
#include "tests/render/parity.hpp"
#include "tests/render/scene_builder.hpp"
#include "tests/render/shared_session.hpp"
#include "tests/render/test_scenes.hpp"

namespace morphcl::test {
namespace {

using Exact = boost::multiprecision::cpp_bin_float_quad;  // 113 bits

Scene with_accuracy(Scene scene, double pixels) {
  scene.accuracy_pixels = pixels;
  return scene;
}

VertexForm form_of(const Draw& draw) { return draw.accuracy->form; }

// The morphed vertex by exact arithmetic from the fp64 matrices and weights, in pixels; w.
struct ExactVertex {
  Exact x, y, w;
};
ExactVertex exact_vertex(const Scene& scene, const Plan& plan, const Draw& draw, std::size_t vertex) {
  const Object& object = scene.objects[draw.object];
  const std::vector<double>& weights = scene.objects[draw.object].morph.weights;
  const ViewVolume volume = make_view_volume(scene.timeline.camera.projection, plan->width, plan->height);
  Exact p[4] = {0, 0, 0, 1};
  for (int c = 0; c < 3; ++c) {
    const Exact base = draw.mesh->positions[vertex][c];
    p[c] = base;
    for (std::size_t t = 0; t < weights.size(); ++t) {
      const MorphTarget& target = draw.mesh->targets[t];
      const Exact end = target.positions[vertex][c], weight = weights[t];
      p[c] += weight * (target.form == TargetForm::absolute ? Exact(end - base) : end);
    }
  }
  const glm::dmat4* const matrices[] = {&scene.timeline.nodes[object.node].static_transform, &plan->world_to_eye,
                                        &volume.eye_to_clip};
  for (const glm::dmat4* m : matrices) {
    Exact q[4] = {0, 0, 0, 0};
    for (int row = 0; row < 4; ++row)
      for (int column = 0; column < 4; ++column) q[row] += Exact((*m)[column][row]) * p[column];
    for (int row = 0; row < 4; ++row) p[row] = q[row];
  }
  return {(p[0] / p[3] + 1) / 2 * plan->width, (1 - p[1] / p[3]) / 2 * plan->height, p[3]};
}

// The largest distance, in x or y, of the first draw's unclipped vertices from their exact places.
double largest_error(const Scene& scene, const Plan& plan) {
  const Draw& draw = plan->draws.at(0);
  const auto vertices = reference::project_vertices(draw, *plan, RasterGrid(plan->width, plan->height));
  Exact largest = 0;
  int seen = 0;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    if (vertices[i].outcode != 0) continue;
    ++seen;
    const ExactVertex exact = exact_vertex(scene, plan, draw, i);
    largest = std::max({largest, Exact(abs(exact.x - Exact(vertices[i].screen.x) / 256)),
                        Exact(abs(exact.y - Exact(vertices[i].screen.y) / 256))});
  }
  EXPECT_GT(seen, 50);
  return static_cast<double>(largest);
}

// A sphere around `middle` in object space, which its transform brings in front of the camera again.
Scene far_sphere(const glm::dvec3& middle, double size, const Projection& projection) {
  SceneBuilder b(1920, 1080);
  Mesh mesh = make_sphere({32, 16});
  for (glm::vec3& p : mesh.positions) p = glm::vec3(glm::dvec3(p) * size + middle);
  glm::dmat4 transform(1.0);
  transform[3] = glm::dvec4(-middle, 1.0);
  b.add(mesh, Shading::flat, transform);
  return b.look({2.5 * size, 1.5 * size, 3 * size}).project(projection).scene();
}

// The same with two targets in use, one of each form.
Scene far_morph(const glm::dvec3& middle) {
  Scene scene = far_sphere(middle, 1, Perspective{45, 0.1, 100});
  Mesh& mesh = scene.meshes[0];
  std::mt19937 random(3);
  std::uniform_real_distribution<float> unit(-1, 1);
  MorphTarget delta{"delta", TargetForm::delta, {}, {}, {}}, absolute{"absolute", TargetForm::absolute, {}, {}, {}};
  for (const glm::vec3& p : mesh.positions) {
    delta.positions.push_back(0.3f * glm::vec3{unit(random), unit(random), unit(random)});
    absolute.positions.push_back(p + 0.5f * glm::vec3{unit(random), unit(random), unit(random)});
  }
  mesh.targets = {delta, absolute};
  scene.objects[0].morph.weights = {0.7, 0.4};
  return scene;
}

// A landscape of 1000 km, seen from where a step of its grid is a metre wide; the camera stands far from its middle.
Scene near_in_a_landscape() {
  SceneBuilder b(1920, 1080);
  Mesh mesh;
  for (int i = 0; i < 40; ++i)
    for (int j = 0; j < 40; ++j) {
      const double reach = i % 2 ? 1 : 5e5;
      mesh.positions.push_back(
          glm::vec3(3e5 + reach * std::sin(0.7 * i + j), 0.1 * (j % 5), 2e5 - reach * (0.2 + 0.02 * j)));
    }
  for (unsigned i = 0; i + 2 < mesh.positions.size(); ++i) mesh.triangles.push_back({i, i + 1, i + 2});
  b.add(mesh, Shading::unlit, glm::dmat4(1.0), {1, 1, 1, 1}, true);
  return b.look({3e5, 2, 2e5 + 4}, {3e5, 1, 2e5}).project(Perspective{60, 0.5, 2e6}).scene();
}

std::vector<Scene> hard_scenes() {
  const Perspective perspective{45, 0.1, 100};
  return {far_sphere({0, 0, 0}, 1, perspective),
          far_sphere({1e4, -1e4, 2e4}, 1, perspective),
          far_sphere({1e7, 3e6, 0}, 40, {Perspective{45, 1, 1e4}}),
          far_sphere({1e5, 0, 0}, 1, Orthographic{-3, 3, -2, 2, 0.1, 20}),
          far_morph({0, 0, 0}),
          far_morph({3e4, 2e3, -5e4}),
          near_in_a_landscape()};
}

// Every form of every scene, the bound against the largest error that occurs.
TEST(VertexAccuracy, EveryFormStaysWithinItsBound) {
  for (std::size_t s = 0; s < hard_scenes().size(); ++s) {
    SCOPED_TRACE(s);
    Scene scene = with_accuracy(hard_scenes()[s], 1e9);
    const std::array<double, 3> bounds = (*plan_frame(scene, 0)).draws.at(0).accuracy->bounds;
    for (const VertexForm form : vertex_forms) {
      const double bound = bounds[static_cast<std::size_t>(form)];
      scene.accuracy_pixels = bound;
      const Plan plan = plan_frame(scene, 0);
      if (form_of(plan->draws[0]) != form) continue;  // a cheaper one has no larger bound
      EXPECT_LE(largest_error(scene, plan), bound) << static_cast<int>(form);
      EXPECT_GE(bound, 1.0 / 512);
    }
  }
}

// One scene for each form, at 0.01 pixels: what is chosen keeps the target, and the next cheaper form really misses it.
TEST(VertexAccuracy, TheCheapestFormThatSufficesIsChosen) {
  constexpr double target = 0.01;
  const struct {
    Scene scene;
    VertexForm form;
  } cases[] = {{far_sphere({0, 0, 0}, 1, Perspective{45, 0.1, 100}), VertexForm::plain},
               {far_sphere({1e4, -1e4, 2e4}, 1, Perspective{45, 0.1, 100}), VertexForm::pivot},
               {far_morph({3e4, 2e3, -5e4}), VertexForm::pivot},
               {near_in_a_landscape(), VertexForm::two_float}};
  for (const auto& [original, form] : cases) {
    Scene scene = with_accuracy(original, target);
    const Plan plan = plan_frame(scene, 0);
    const VertexAccuracy& accuracy = *plan->draws.at(0).accuracy;
    EXPECT_EQ(accuracy.form, form) << accuracy.bounds[0] << ' ' << accuracy.bounds[1] << ' ' << accuracy.bounds[2];
    EXPECT_TRUE(accuracy.suffices);
    EXPECT_LE(largest_error(scene, plan), target);
    if (form == VertexForm::plain) continue;
    scene.accuracy_pixels = accuracy.bounds[static_cast<std::size_t>(form) - 1];
    const Plan cheaper = plan_frame(scene, 0);
    ASSERT_LT(form_of(cheaper->draws.at(0)), form);
    EXPECT_GT(largest_error(scene, cheaper), target);
  }
}

TEST(VertexAccuracy, WithoutAStatedErrorVerticesArePlain) {
  const Scene scene = far_morph({3e4, 2e3, -5e4});
  for (const Draw& draw : (*plan_frame(scene, 0)).draws) EXPECT_EQ(draw.accuracy, nullptr);
}

TEST(VertexAccuracy, WhatNoFormKeepsGetsTheBestAndSaysSo) {
  const Scene scene = with_accuracy(near_in_a_landscape(), 1e-6);
  const Plan plan = plan_frame(scene, 0);
  EXPECT_EQ(form_of(plan->draws.at(0)), VertexForm::two_float);
  EXPECT_FALSE(plan->draws[0].accuracy->suffices);
}

// Among the test scenes and the hard ones, with errors that ask for each form.
TEST(VertexAccuracy, TheDeviceDrawsTheReferencesBits) {
  const auto device = make_device_renderer(shared_session()), reference = make_reference_renderer();
  int drawn[3] = {0, 0, 0};
  const auto expect_parity = [&](Scene scene, double pixels) {
    scene.accuracy_pixels = pixels;
    const Plan plan = plan_frame(scene, 0), whole = plan_frame(scene, 0, {.leave_out = false});
    for (const Draw& draw : plan->draws) ++drawn[static_cast<std::size_t>(form_of(draw))];
    FrameBuffer expected(plan->width, plan->height, {Channel::color, Channel::depth}),
        actual(plan->width, plan->height, {Channel::color, Channel::depth});
    reference->render(plan, expected);
    device->render(plan, actual);
    EXPECT_TRUE(same_pixels(expected, actual)) << pixels;
    device->render(whole, actual);
    EXPECT_TRUE(same_pixels(expected, actual)) << pixels << ", nothing left out";
  };
  for (const double pixels : {1e-9, 0.00197, 0.0022})
    for (const TestScene& test : test_scenes(150, 90)) {
      SCOPED_TRACE(test.name);
      expect_parity(test.scene, pixels);
    }
  for (Scene scene : hard_scenes()) {
    scene.image.width = 240;
    scene.image.height = 135;
    scene.accuracy_pixels = 1e9;
    const std::array<double, 3> bounds = (*plan_frame(scene, 0)).draws.at(0).accuracy->bounds;
    for (const double pixels : {bounds[0], bounds[1], bounds[2], 1e-9}) expect_parity(scene, pixels);
  }
  for (const int count : drawn) EXPECT_GE(count, 4);
}

// A draw whose form or pivot changes from one frame to the next is not taken for the same.
TEST(VertexAccuracy, KeptVerticesAreThoseOfTheSameForm) {
  const auto device = make_device_renderer(shared_session()), reference = make_reference_renderer();
  Scene scene = far_morph({3e4, 2e3, -5e4});
  scene.image.width = 240;
  scene.image.height = 135;
  scene.accuracy_pixels = 1e9;
  const std::array<double, 3> bounds = (*plan_frame(scene, 0)).draws.at(0).accuracy->bounds;
  const Planner planner(scene);
  Plan plan = planner.plan(0);
  FrameBuffer expected(plan->width, plan->height, {Channel::color, Channel::depth}),
      actual(plan->width, plan->height, {Channel::color, Channel::depth});
  for (const double pixels : {bounds[0], bounds[1], bounds[2], bounds[1], bounds[0]}) {
    scene.accuracy_pixels = pixels;
    plan = planner.plan(0);
    reference->render(plan, expected);
    device->render(plan, actual);
    EXPECT_TRUE(same_pixels(expected, actual)) << pixels;
  }
}

}  // namespace
}  // namespace morphcl::test
