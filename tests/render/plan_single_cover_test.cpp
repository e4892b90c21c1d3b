// The proof that no pixel is covered twice: never given where one is, and given for what it is meant for.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "host/render/frame/frame_plan.hpp"
#include "host/render/frame/scene_vertices.hpp"
#include "host/render/plan/screen_boundary.hpp"
#include "host/render/plan/single_cover.hpp"
#include "morphcl/planner.hpp"
#include "morphcl/solids.hpp"
#include "morphcl/transform.hpp"
#include "tests/render/scene_builder.hpp"
#include "tests/render/test_scenes.hpp"

namespace morphcl::test {
namespace {

// How many front faces cover the pixel that is covered most, counted pixel by pixel.
int deepest_cover(const Plan& plan) {
  const Draw& draw = plan->draws.at(0);
  const auto vertices = reference::project_vertices(draw, *plan, RasterGrid(plan->width, plan->height));
  std::vector<int> count(static_cast<std::size_t>(plan->width) * plan->height, 0);
  for (const glm::uvec3& triangle : draw.mesh->triangles) {
    const int order[3] = {0, draw.mirrored ? 1 : 2, draw.mirrored ? 2 : 1};
    GridPoint p[3];
    for (int i = 0; i < 3; ++i) {
      const reference::ScreenVertex& screen = vertices[triangle[order[i]]].screen;
      p[i] = {screen.x, screen.y};
    }
    if (doubled_area(p[0], p[1], p[2]) <= 0) continue;
    for (int y = 0; y < plan->height; ++y)
      for (int x = 0; x < plan->width; ++x) {
        bool inside = true;
        for (int i = 0; i < 3; ++i) {
          const GridPoint &from = p[i], &to = p[(i + 1) % 3];
          const std::int64_t side = doubled_area(from, to, {x * 256 + 128, y * 256 + 128});
          const bool top_or_left = to.y < from.y || (to.y == from.y && to.x > from.x);
          inside &= side > 0 || (side == 0 && top_or_left);
        }
        count[static_cast<std::size_t>(y) * plan->width + x] += inside;
      }
  }
  return *std::max_element(count.begin(), count.end());
}

glm::dmat4 turned(std::mt19937& random, double scale = 1) {
  std::uniform_real_distribution<double> number(-1, 1);
  CompositeTransform turn;
  turn.scale(glm::dvec3(scale));
  const glm::dvec3 axis{number(random), number(random), number(random) + 1.5};
  turn.rotate_about_axis({0, 0, 0}, axis, 180 * number(random));
  turn.translate({0.3 * number(random), 0.3 * number(random), 0.3 * number(random)});
  return turn.matrix();
}

// A sphere's narrow triangles at the outline may turn over where they are snapped: those are not asked for.
TEST(SingleCover, BoxesAreProvedFromEverySide) {
  std::mt19937 random(1);
  for (int trial = 0; trial < 60; ++trial) {
    SceneBuilder b(80, 60);
    glm::dmat4 transform = turned(random);
    if (trial % 3 == 0) transform[0] = -transform[0];  // mirrored
    b.add(make_cube(), trial % 4 < 2 ? Shading::flat : Shading::smooth, transform);
    b.look({0.2, 0.4, 5});
    if (trial % 5 == 0) b.project(Orthographic{-2, 2, -1.5, 1.5, 0, 20});
    const Plan plan = plan_frame(b.scene(), 0);
    EXPECT_FALSE(plan->tests_depth) << trial;
    EXPECT_TRUE(has_convex_outline(*plan)) << trial;
    EXPECT_EQ(deepest_cover(plan), 1) << trial;
  }
}

TEST(SingleCover, WhatMorphsBetweenConvexSolidsIsProvedInEveryStep) {
  const Scene scene = pyramid_to_cube(160, 90);
  const Planner planner(scene);
  for (std::int64_t frame = 0; frame <= 100; ++frame) EXPECT_FALSE((*planner.plan(frame)).tests_depth) << frame;
}

// Solids, surfaces and tangles with random faults: wherever the proof is given, counting agrees.
TEST(SingleCover, IsNeverProvedWhereAPixelIsCoveredTwice) {
  std::mt19937 random(2);
  int proved = 0, refused = 0, overlapping = 0;
  for (int trial = 0; trial < 400; ++trial) {
    Mesh mesh;
    switch (trial % 5) {
      case 0:
        mesh = make_torus({6, 4});
        break;
      case 1:
        mesh = make_grid({3, 3});
        break;
      case 2:
        mesh = make_cube();
        break;
      case 3:
        mesh = make_sphere({8, 4});
        break;
      default:
        mesh = triangle_soup(static_cast<unsigned>(trial), 3, 8, 8).meshes[0];
    }
    std::uniform_real_distribution<float> shake(-0.25f, 0.25f);
    if (trial % 2)
      for (glm::vec3& p : mesh.positions) p += glm::vec3{shake(random), shake(random), shake(random)};
    if (trial % 7 == 0) mesh.triangles.push_back(mesh.triangles[random() % mesh.triangles.size()]);
    if (trial % 11 == 0)
      mesh.triangles.erase(mesh.triangles.begin() + static_cast<int>(random() % mesh.triangles.size()));
    SceneBuilder b(40, 30);
    b.add(mesh, Shading::flat, turned(random, trial % 5 == 4 ? 0.2 : 0.8));
    const Plan plan = plan_frame(b.look({0, 0, 5}).scene(), 0);
    if (plan->clips) continue;
    const int deepest = deepest_cover(plan);
    overlapping += deepest > 1;
    (plan->tests_depth ? refused : proved) += 1;
    if (!plan->tests_depth) {
      EXPECT_LE(deepest, 1) << "trial " << trial;
    }
  }
  EXPECT_GT(proved, 40);
  EXPECT_GT(refused, 40);
  EXPECT_GT(overlapping, 40);
}

TEST(SingleCover, IsOnlyForOneSingleSidedDrawOfWhichNothingIsClipped) {
  const auto tests_depth = [](bool double_sided, int objects, double distance, Shading shading, double far) {
    SceneBuilder b(64, 48);
    for (int i = 0; i < objects; ++i) b.add(make_cube(), shading, place({2.5 * i, 0, 0}), {1, 1, 1, 1}, double_sided);
    b.look({0, 0, distance}).project(Perspective{45, 0.1, far});
    return (*plan_frame(b.scene(), 0)).tests_depth;
  };
  EXPECT_FALSE(tests_depth(false, 1, 5, Shading::flat, 100));
  EXPECT_TRUE(tests_depth(true, 1, 5, Shading::flat, 100));
  EXPECT_TRUE(tests_depth(false, 2, 5, Shading::flat, 100));
  EXPECT_TRUE(tests_depth(false, 1, 1.05, Shading::flat, 100)) << "clipped";
  EXPECT_TRUE(tests_depth(false, 1, 5, Shading::wireframe, 100));
  EXPECT_TRUE(tests_depth(false, 1, 5, Shading::flat, 4.0 + 1e-7)) << "the far plane touches the front face";
}

using Ring = std::vector<GridPoint>;

ScreenBoundary boundary_of(const std::vector<std::array<GridPoint, 3>>& triangles) {
  ScreenBoundary boundary(triangles.size());
  for (const auto& [a, b, c] : triangles) boundary.add(a, b, c);
  boundary.finish();
  return boundary;
}

// Triangles from one point to each edge of a closed ring around it.
ScreenBoundary fan(const GridPoint& middle, const Ring& ring) {
  std::vector<std::array<GridPoint, 3>> triangles;
  for (std::size_t i = 0; i < ring.size(); ++i) triangles.push_back({middle, ring[i], ring[(i + 1) % ring.size()]});
  return boundary_of(triangles);
}

TEST(ScreenBoundary, OfASquareIsConvex) {
  const ScreenBoundary square = fan({0, 0}, {{9, 9}, {-9, 9}, {-9, -9}, {9, -9}});
  EXPECT_TRUE(square.is_star_shaped());
  EXPECT_TRUE(square.is_convex());
}

TEST(ScreenBoundary, OfAStarIsStarShapedAndNotConvex) {
  const ScreenBoundary star =
      fan({0, 0}, {{90, 0}, {10, 10}, {0, 90}, {-10, 10}, {-90, 0}, {-10, -10}, {0, -90}, {10, -10}});
  EXPECT_TRUE(star.is_star_shaped());
  EXPECT_FALSE(star.is_convex());
}

TEST(ScreenBoundary, ThatGoesRoundTwiceIsNot) {
  const Ring ring = {{9, 9}, {-9, 9}, {-9, -9}, {9, -9}};
  std::vector<std::array<GridPoint, 3>> twice;
  for (int round = 0; round < 2; ++round)
    for (std::size_t i = 0; i < 4; ++i) twice.push_back({GridPoint{0, 0}, ring[i], ring[(i + 1) % 4]});
  EXPECT_FALSE(boundary_of(twice).is_star_shaped());
}

TEST(ScreenBoundary, OfTwoPiecesIsNot) {
  EXPECT_FALSE(boundary_of({{{{0, 0}, {9, 0}, {0, 9}}}, {{{100, 0}, {109, 0}, {100, 9}}}}).is_star_shaped());
}

TEST(ScreenBoundary, OfOverlappingTrianglesIsNot) {
  EXPECT_FALSE(boundary_of({{{{0, 0}, {99, 0}, {0, 99}}}, {{{1, 1}, {100, 1}, {1, 100}}}}).is_star_shaped());
}

TEST(ScreenBoundary, OfNothingIsStarShaped) { EXPECT_TRUE(boundary_of({}).is_star_shaped()); }

}  // namespace
}  // namespace morphcl::test
