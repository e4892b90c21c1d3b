// trace() against the same pipeline in 113 bits, within the bounds that it prints.
#include "morphcl/trace.hpp"

#include <gtest/gtest.h>

#include "morphcl/camera.hpp"
#include "morphcl/error.hpp"
#include "morphcl/solids.hpp"
#include "tests/render/trace_reference.hpp"
#include "tests/support/random.hpp"

namespace morphcl {
namespace {

using test::Homogeneous;
using test::Point;
using test::Quad;
using test_support::Random;

// A scene of random parameters, and what it does to a point from its mesh to the world.
class RandomScene {
 public:
  explicit RandomScene(std::uint64_t seed) : random_(seed) {
    size_ = std::exp2(random_.in(-8, 8));
    far_away_ = random_.integer_in(0, 3) == 0 ? 1e5 : 3;
    Mesh mesh = make_mesh();
    CompositeTransform placing;
    for (long long count = random_.integer_in(0, 5); count > 0; --count) add_step(placing);
    scene.add_object("solid", std::move(mesh), placing);
    scene.objects[0].morph.weights = {random_.in(-1, 2), random_.in(0, 1)};
    pose_node(scene.timeline.nodes[0]);
    Node parent;
    pose_node(parent);
    scene.timeline.nodes.push_back(parent);
    scene.timeline.nodes[0].parent = 1;
    scene.image.width = static_cast<int>(random_.integer_in(1, 4000));
    scene.image.height = static_cast<int>(random_.integer_in(1, 4000));
    place_camera();
    if (random_.integer_in(0, 1) == 1) convention.vectors = VectorForm::row;
    if (random_.integer_in(0, 1) == 1) convention.handedness = Handedness::left;
    if (random_.integer_in(0, 1) == 1) convention.depth = NdcDepth::zero_to_one;
  }

  Scene scene;
  Convention convention;

  Point morphed() const {
    const Mesh& mesh = scene.meshes[0];
    const std::vector<double>& weights = scene.objects[0].morph.weights;
    const Point base = test::quad(mesh.positions[0]), target = test::quad(mesh.targets[1].positions[0]);
    const Point moved = test::combined(base, weights[0], test::quad(mesh.targets[0].positions[0]));
    return test::combined(moved, weights[1], test::combined(target, -1, base));
  }
  Point in_world() const {
    Point p = morphed();
    for (const auto& step : steps_) p = step(p);
    return p;
  }
  Point in_eye(const Point& p) const {
    const Camera& camera = scene.timeline.camera;
    return test::seen_from(p, test::quad(camera.eye), test::quad(camera.target), test::quad(camera.up));
  }
  Homogeneous in_clip(const Point& p) const {
    const Quad aspect = Quad(scene.image.width) / scene.image.height;
    return std::visit(test::QuadProjection{p, aspect}, scene.timeline.camera.projection);
  }

 private:
  Mesh make_mesh() {
    Mesh mesh;
    for (int i = 0; i < 3; ++i) mesh.positions.emplace_back(random_.vector(size_));
    mesh.triangles = {{0, 1, 2}};
    for (const TargetForm form : {TargetForm::delta, TargetForm::absolute}) {
      MorphTarget target{form == TargetForm::delta ? "swollen" : "other", form, {}, {}, {}};
      for (int i = 0; i < 3; ++i) target.positions.emplace_back(random_.vector(size_));
      mesh.targets.push_back(target);
    }
    return mesh;
  }

  void add_step(CompositeTransform& placing) {
    const glm::dvec3 a = random_.vector(size_ * far_away_), b = random_.vector(size_ * far_away_),
                     f = random_.vector(2);
    const double degrees = random_.in(-720, 720);
    const Point origin{}, from = test::quad(a);
    const Quad angle = test::quad_radians(degrees);
    switch (random_.integer_in(0, 6)) {
      case 0:
        placing.translate(a);
        steps_.emplace_back([=](const Point& p) { return test::combined(p, 1, from); });
        break;
      case 1:
        placing.scale(f);
        steps_.emplace_back([=](const Point& p) { return Point{p[0] * f.x, p[1] * f.y, p[2] * f.z}; });
        break;
      case 2:
        placing.scale_about(a, f);
        steps_.emplace_back([=](const Point& p) {
          const Point d = test::combined(p, -1, from);
          return test::combined(from, 1, {d[0] * f.x, d[1] * f.y, d[2] * f.z});
        });
        break;
      case 3:
        placing.rotate_x_degrees(degrees);
        steps_.emplace_back([=](const Point& p) { return test::turned(p, origin, {1, 0, 0}, angle); });
        break;
      case 4:
        placing.rotate_y_degrees(degrees).rotate_z_degrees(degrees);
        steps_.emplace_back([=](const Point& p) {
          return test::turned(test::turned(p, origin, {0, 1, 0}, angle), origin, {0, 0, 1}, angle);
        });
        break;
      case 5:
        placing.rotate_about_axis(a, b, degrees);
        steps_.emplace_back(
            [=](const Point& p) { return test::turned(p, from, test::combined(test::quad(b), -1, from), angle); });
        break;
      default:
        placing.shear(f.x, f.y, 0.5, f.z, 0.25, f.x);
        steps_.emplace_back([=](const Point& p) {
          return Point{p[0] + f.x * p[1] + f.y * p[2], p[1] + Quad(0.5) * p[0] + f.z * p[2],
                       p[2] + Quad(0.25) * p[0] + f.x * p[1]};
        });
    }
  }

  void pose_node(Node& node) {
    node.translation = random_.vector(size_);
    const glm::dvec3 axis = random_.vector(1);
    node.rotation = glm::dquat(random_.in(-1, 1), axis.x, axis.y, axis.z);
    node.scale = random_.vector(1) + glm::dvec3(1.5);
    steps_.emplace_back([=](const Point& p) {
      const Point scaled{p[0] * node.scale.x, p[1] * node.scale.y, p[2] * node.scale.z};
      return test::combined(test::turned(scaled, node.rotation), 1, test::quad(node.translation));
    });
  }

  void place_camera() {
    Camera& camera = scene.timeline.camera;
    camera.eye = random_.vector(size_ * far_away_);
    camera.target = random_.vector(size_ * far_away_);
    camera.up = random_.vector(1);
    const double near = size_ * std::exp2(random_.in(-10, 2)), far = near * (1 + std::exp2(random_.in(-3, 20)));
    const double left = random_.in(-2, 1), bottom = random_.in(-2, 1);
    const double right = left + random_.in(0.5, 3), top = bottom + random_.in(0.5, 3), degrees = random_.in(5, 150);
    const double reach = random_.integer_in(0, 3) == 0 ? std::numeric_limits<double>::infinity() : far;
    const Fit fit = Fit::stretch;
    switch (random_.integer_in(0, 5)) {
      case 0:
        camera.projection = Perspective{degrees, near, reach};
        break;
      case 1:
        camera.projection = HorizontalPerspective{degrees, near, reach};
        break;
      case 2:
        camera.projection = Frustum{left * near, right * near, bottom * near, top * near, near, reach, fit};
        break;
      case 3:
        camera.projection = CentralProjection{left, right, bottom, top, near, reach, 2 * near, fit};
        break;
      case 4:
        camera.projection = Orthographic{left * size_, right * size_, bottom * size_, top * size_, -near, far, fit};
        break;
      default:
        camera.projection =
            Oblique{left * size_, right * size_, bottom * size_, top * size_, -near, far, {left, top}, near, fit};
    }
  }

  Random random_;
  double size_, far_away_;
  std::vector<std::function<Point(const Point&)>> steps_;
};

// The largest part of its bound that an error is, over all components: of fp64, and of fp32.
struct Margin {
  double own = 0, single = 0;
};

void expect_within(const TracePoint& point, const Homogeneous& exact, const char* where, std::uint64_t seed,
                   Margin& margin) {
  for (int i = 0; i < 4; ++i) {
    const double error = std::abs(static_cast<double>(exact[i] - Quad(point.value[i])));
    ASSERT_LE(error, point.bound[i]) << where << " " << i << " of scene " << seed << ": " << point.value[i]
                                     << ", exact " << exact[i];
    if (!std::isfinite(point.bound[i])) continue;
    const double single = std::abs(static_cast<double>(exact[i] - Quad(point.single[i])));
    ASSERT_LE(single, point.bound[i]) << where << " " << i << " of scene " << seed << " in fp32: " << point.single[i]
                                      << ", exact " << exact[i];
    if (point.bound[i] == 0) continue;
    margin.own = std::max(margin.own, error / point.bound[i]);
    margin.single = std::max(margin.single, single / point.bound[i]);
  }
}

// The exact coordinates of each space in the convention.
std::array<Homogeneous, 6> exact_points(const RandomScene& random) {
  const bool left = random.convention.handedness == Handedness::left;
  const bool from_0 = random.convention.depth == NdcDepth::zero_to_one;
  const auto handed = [left](const Point& p) { return Homogeneous{p[0], p[1], left ? -p[2] : p[2], 1}; };
  const Point world = random.in_world(), eye = random.in_eye(world);
  Homogeneous clip = random.in_clip(eye);
  if (from_0) clip[2] = (clip[2] + clip[3]) / 2;
  const Homogeneous ndc{clip[0] / clip[3], clip[1] / clip[3], clip[2] / clip[3], 1};
  const Homogeneous view{(ndc[0] + 1) / 2 * random.scene.image.width, (1 - ndc[1]) / 2 * random.scene.image.height,
                         from_0 ? ndc[2] : (ndc[2] + 1) / 2, 1};
  return {handed(random.morphed()), handed(world), handed(eye), clip, ndc, view};
}

TEST(Trace, EqualsThePipelineIn113BitsWithinItsBounds) {
  Margin margin;
  int divided = 0;
  for (std::uint64_t seed = 1; seed <= 10000; ++seed) {
    const RandomScene random(seed);
    const Trace trace = morphcl::trace(random.scene, 0, {.convention = random.convention});
    const std::array<Homogeneous, 6> exact = exact_points(random);
    expect_within(trace.start, exact[0], "object", seed, margin);
    for (const TraceStage& stage : trace.stages)
      expect_within(stage.after, exact[static_cast<std::size_t>(stage.to)], name_of(stage.to), seed, margin);
    if (testing::Test::HasFatalFailure()) return;
    divided += trace.stages.size() == 5;
    if (trace.stages.size() < 5) {
      ASSERT_EQ(trace.stages.size(), 3u);
      ASSERT_LE(exact[3][3], Quad(2 * trace.stages.back().after.bound.w)) << "scene " << seed;
      ASSERT_FALSE(trace.notes.empty());
    }
  }
  EXPECT_GT(divided, 5000);
  std::cout << "largest part of the bound: " << margin.own << " in fp64, " << margin.single << " in fp32; " << divided
            << " points in front of the eye\n";
}

TEST(Trace, WhatTheRenderersHaveIsWithinTheBounds) {
  int rendered = 0;
  for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
    const RandomScene random(seed);
    const Trace trace = morphcl::trace(random.scene, 0, {});
    if (!trace.rendered || trace.stages.size() < 5) continue;
    ++rendered;
    const TracePoint &clip = trace.stages[2].after, &view = trace.stages[4].after;
    EXPECT_LE(std::abs(trace.rendered->clip.x - clip.value.x), clip.bound.x) << seed;
    EXPECT_LE(std::abs(trace.rendered->clip.y - clip.value.y), clip.bound.y) << seed;
    EXPECT_LE(std::abs(trace.rendered->clip.z - clip.value.w), clip.bound.w) << seed;
    for (int i = 0; i < 2; ++i)  // the grid of 1/256 pixel comes on top
      EXPECT_LE(std::abs(trace.rendered->subpixel[i] / 256.0 - view.value[i]), view.bound[i] + 1 / 512.0) << seed;
  }
  EXPECT_GT(rendered, 100);
}

// As written: columns are multiplied from the left, rows from the right.
glm::dvec4 times(const Convention& convention, const glm::dmat4& matrix, const glm::dvec4& point) {
  return convention.vectors == VectorForm::row ? point * matrix : matrix * point;
}

TEST(Trace, MatricesAreAsTheConventionWritesThem) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    const RandomScene random(seed);
    const Trace trace = morphcl::trace(random.scene, 0, {.convention = random.convention});
    for (const TraceStage& stage : trace.stages) {
      if (stage.divides) continue;
      const glm::dvec4 there = times(random.convention, stage.matrix, stage.before.value);
      for (int i = 0; i < 4; ++i) EXPECT_NEAR(there[i], stage.after.value[i], 2 * stage.after.bound[i]) << seed;
      if (stage.to == TraceSpace::viewport) continue;
      const glm::dvec4 at_once = times(random.convention, stage.composite, trace.start.value);
      for (int i = 0; i < 4; ++i) EXPECT_NEAR(at_once[i], stage.after.value[i], 2 * stage.after.bound[i]) << seed;
    }
  }
}

// One vertex at `at`.
Scene scene_of(const glm::vec3& at, const CompositeTransform& placing = {}) {
  Mesh mesh;
  mesh.positions = {at, at + glm::vec3(1, 0, 0), at + glm::vec3(0, 1, 0)};
  mesh.triangles = {{0, 1, 2}};
  Scene scene;
  scene.add_object("point", mesh, placing);
  scene.image.width = scene.image.height = 400;
  return scene;
}

TEST(TraceExercises, CentralProjectionOfTheBoard) {
  Scene scene = scene_of({3, 5, 7});
  scene.timeline.camera.projection = CentralProjection{-20, 20, -20, 20, 0.1, 100, 10};
  scene.timeline.camera.eye = {0, 0, 10};
  const Trace trace = morphcl::trace(scene, 0, {.convention = row_right_handed});
  const glm::dvec4 clip = trace.stages[2].after.value, ndc = trace.stages[3].after.value;
  EXPECT_NEAR(clip.w, 3, 1e-15);  // [3 5 0.3], times 10
  EXPECT_NEAR(20 * ndc.x, 10, 1e-14);
  EXPECT_NEAR(20 * ndc.y, 50.0 / 3, 1e-14);
}

TEST(TraceExercises, PyramidTurnedBy45DegreesAndHalved) {
  CompositeTransform placing;
  placing.rotate_x_degrees(45).scale({0.5, 0.5, 0.5});
  Scene scene;
  scene.add_object("pyramid", make_pyramid_to_cube(), placing);
  const double s = std::sqrt(2.0);
  const glm::dvec3 right[4] = {{25, 5 * s, 20 * s}, {75, 5 * s, 20 * s}, {75, 30 * s, 45 * s}, {25, 30 * s, 45 * s}};
  const glm::vec3 base[4] = {{50, 50, 30}, {150, 50, 30}, {150, 150, 30}, {50, 150, 30}};
  for (int i = 0; i < 4; ++i) {
    const Trace trace = morphcl::trace(scene, 0, {.point = base[i]});
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(trace.stages[0].after.value[c], right[i][c], 1e-13);
  }
  // The matrix is that of the two, and its inverse the reading of axes.
  const Trace trace = morphcl::trace(scene, 0);
  const double c = 0.5 * std::sqrt(0.5);
  const glm::dmat3 right_matrix(0.5, 0, 0, 0, c, c, 0, -c, c);
  for (int column = 0; column < 3; ++column)
    for (int row = 0; row < 3; ++row) {
      EXPECT_NEAR(trace.stages[0].matrix[column][row], right_matrix[column][row], 1e-16);
      EXPECT_NEAR((*trace.stages[0].inverse)[column][row], 4 * right_matrix[row][column], 1e-15);
    }
}

TEST(TraceExercises, TeapotCentresInTheFrustum) {
  const glm::vec3 centres[5] = {{0, 0, 3}, {2, 2, 2}, {-2, 2, 1}, {-2, -2, 0}, {2, -2, -1}};
  const double right[5] = {1.0 / 7, 3.0 / 7, 31.0 / 49, 11.0 / 14, 19.0 / 21};
  for (int i = 0; i < 5; ++i) {
    Scene scene = scene_of(centres[i]);
    scene.timeline.camera.projection = Frustum{-1, 1, -1, 1, 3, 10};
    scene.timeline.camera.eye = {0, 0, 8};
    EXPECT_NEAR(morphcl::trace(scene, 0).stages[3].after.value.z, right[i], 1e-15);
  }
}

TEST(TraceExercises, MorphAt37Of100) {
  Scene scene;
  scene.add_object("solid", make_pyramid_to_cube());
  scene.objects[0].morph.weights = {0.37};
  std::vector<glm::dvec3> corners;
  for (std::size_t v = 0; v < scene.meshes[0].positions.size(); ++v)
    corners.emplace_back(morphcl::trace(scene, 0, {.vertex = v}).start.value);
  for (const glm::dvec3& right : {glm::dvec3(81.5, 81.5, 100), glm::dvec3(118.5, 81.5, 100),
                                  glm::dvec3(118.5, 118.5, 100), glm::dvec3(81.5, 118.5, 100)})
    EXPECT_TRUE(std::any_of(corners.begin(), corners.end(),
                            [&](const glm::dvec3& corner) { return glm::length(corner - right) < 1e-13; }));
}

TEST(Trace, AVertexBehindTheEyeIsSaidInWords) {
  const Trace trace = morphcl::trace(scene_of({0, 0, 8}), 0);  // the eye is at (0, 0, 5)
  EXPECT_EQ(trace.stages.size(), 3u);
  EXPECT_EQ(*trace.distance, -3);
  EXPECT_FALSE(trace.pixel);
  ASSERT_EQ(trace.notes.size(), 1u);
  EXPECT_EQ(trace.notes[0].substr(0, 24), "behind the eye by 3: w =");
}

TEST(Trace, AVertexInThePlaneOfTheEyeIsSaidInWords) {
  const Trace trace = morphcl::trace(scene_of({1, 0, 5}), 0);
  EXPECT_EQ(trace.stages.size(), 3u);
  ASSERT_EQ(trace.notes.size(), 1u);
  EXPECT_EQ(trace.notes[0], "in the plane through the eye: w = 0, its image is infinitely far away");
}

TEST(Trace, RefusesWhatIsNotThereAndSaysWhatIs) {
  const Scene scene = scene_of({0, 0, 0});
  const auto refusal = [&](const TraceRequest& request) -> std::string {
    try {
      morphcl::trace(scene, 0, request);
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(refusal({.object = "pot"}), "there is no object \"pot\"; there are \"point\"");
  EXPECT_EQ(refusal({.vertex = 3}), "vertex 3 of object \"point\"; its mesh has 3 vertices, 0 to 2");
}

// A triangle that leans away from the eye, and what a pixel of it shows.
Scene leaning_triangle() {
  Mesh mesh;
  mesh.positions = {{-1, -1, 3}, {1, -1, -4}, {0, 2, -1}};
  mesh.triangles = {{0, 1, 2}};
  Scene scene;
  scene.add_object("leaning", mesh);
  scene.image.width = 300;
  scene.image.height = 200;
  return scene;
}

TEST(TracePixel, TheHitComesBackToThePixelsCentre) {
  const Scene scene = leaning_triangle();
  int hits = 0;
  for (int y = 5; y < 200; y += 13)
    for (int x = 5; x < 300; x += 13) try {
        const PixelTrace trace = trace_pixel(scene, 0, {x, y});
        ++hits;
        const glm::dvec4 back = trace.forward.stages.back().after.value;
        EXPECT_NEAR(back.x, x + 0.5, 1e-10);
        EXPECT_NEAR(back.y, y + 0.5, 1e-10);
        const glm::dvec3 on_ray = trace.world_from + trace.distance * trace.world_along;
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(on_ray[c], trace.in_world[c], 1e-12);
        EXPECT_NEAR(trace.ndc_depth, trace.mean_depth, 1e-12);
        EXPECT_NEAR(trace.ndc_depth, -trace.depth_a + trace.depth_b / trace.distance, 1e-12);
        // The renderers' plane goes through the vertices where they are, to 1/32768 pixel.
        EXPECT_NEAR(trace.rendered_distance, trace.distance, 1e-4 * trace.distance);
        double sum = 0, picture = 0, distance = 0;
        for (const TraceCorner& corner : trace.corners) {
          sum += corner.weight;
          picture += corner.picture_weight;
          distance += corner.picture_weight / corner.distance;
        }
        EXPECT_NEAR(sum, 1, 1e-14);
        EXPECT_NEAR(picture, 1, 1e-14);
        EXPECT_NEAR(1 / distance, trace.distance, 1e-12);
      } catch (const Error&) {
      }
  EXPECT_GT(hits, 20);
}

TEST(TracePixel, ATriangleThatReachesBehindTheEyeHasWeightsAllTheSame) {
  Scene scene = leaning_triangle();
  scene.meshes[0].positions[0].z = 7;  // the eye is at z = 5
  scene.objects[0].material.double_sided = true;
  int cut = 0;
  for (int y = 1; y < 200; y += 7)
    for (int x = 1; x < 300; x += 7) try {
        const PixelTrace trace = trace_pixel(scene, 0, {x, y});
        cut += !trace.divisible;
        EXPECT_NEAR(trace.forward.stages.back().after.value.x, x + 0.5, 1e-9);
        EXPECT_NEAR(trace.forward.stages.back().after.value.y, y + 0.5, 1e-9);
      } catch (const Error&) {
      }
  EXPECT_GT(cut, 10);
}

TEST(TracePixel, APixelThatShowsNothingSaysWhereObjectsAre) {
  const auto refusal = [](const glm::ivec2& pixel) -> std::string {
    try {
      trace_pixel(leaning_triangle(), 0, pixel);
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(refusal({0, 0}).substr(0, 64), "pixel (0, 0): shows nothing at frame 0; vertices lie in columns ");
  EXPECT_EQ(refusal({300, 0}), "pixel (300, 0): outside the picture; 0,0 to 299,199 are in it");
}

// A plan from above: x to the right, -z upwards, and turned.
TEST(TracePlane, IsThatOfSpaceInTwoDimensions) {
  for (const glm::dvec3& up : {glm::dvec3(0, 0, -1), glm::dvec3(1, 0, -1), glm::dvec3(-3, 0, 1)}) {
    Scene scene = scene_of({3, 5, 7});
    scene.timeline.camera.projection = Orthographic{-8, 8, -4.5, 4.5, 0, 20};
    scene.timeline.camera.eye = {1, 10, 2};
    scene.timeline.camera.target = {1, 0, 2};
    scene.timeline.camera.up = up;
    const Trace trace = morphcl::trace(scene, 0);
    ASSERT_TRUE(trace.plane);
    EXPECT_EQ(trace.plane->axes, "x, -z");
    EXPECT_EQ(trace.plane->start, glm::dvec2(3, -7));
    ASSERT_EQ(trace.plane->steps.size(), 3u);
    for (int c = 0; c < 2; ++c) {
      EXPECT_NEAR(trace.plane->steps[0].point[c], trace.stages[1].after.value[c], 1e-14);
      EXPECT_NEAR(trace.plane->steps[1].point[c], trace.stages[3].after.value[c], 1e-14);
      EXPECT_NEAR(trace.plane->steps[2].point[c], trace.stages[4].after.value[c], 1e-12);
    }
  }
}

TEST(TracePlane, APerspectiveHasNone) { EXPECT_FALSE(morphcl::trace(scene_of({0, 0, 0}), 0).plane); }

}  // namespace
}  // namespace morphcl
