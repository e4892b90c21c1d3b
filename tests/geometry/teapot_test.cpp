#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "host/geometry/bounds.hpp"
#include "host/geometry/teapot_patches.hpp"
#include "morphcl/solids.hpp"
#include "tests/geometry/closed_surface.hpp"

namespace morphcl {
namespace {

constexpr int revolved_parts = 6, tube_parts = 4;
constexpr int bottom_first = 20, tubes_first = 24;

constexpr int samples = 16;
double sample(int i) { return static_cast<double>(i) / samples; }

TEST(TeapotPatches, AreThirtyTwo) { EXPECT_EQ(teapot_patches().size(), 32u); }

TEST(TeapotPatches, HaveTheClassicBounds) {
  Box box;
  for (const BezierPatch& patch : teapot_patches())
    for (int i = 0; i <= samples; ++i)
      for (int j = 0; j <= samples; ++j) box.include(evaluate_patch(patch, sample(i), sample(j)).position);
  EXPECT_EQ(box.lower, glm::dvec3(-3, -2, 0));
  EXPECT_NEAR(box.upper.x, 3.434, 0.001);  // the spout's lip, between two samples
  EXPECT_EQ(box.upper.y, 2);
  EXPECT_NEAR(box.upper.z, 3.15, 4 * std::ldexp(1.0, -52));  // the weights of the point sum to 1 within rounding
}

// The surface ends where a curve belongs to one patch only; everywhere else two patches share it, bit for bit.
TEST(TeapotPatches, JoinTheirNeighboursExactly) {
  const auto& patches = teapot_patches();
  const auto expect_joined = [&](int a, double ua, double va, int b, double ub, double vb, bool along_u) {
    for (int i = 0; i <= samples; ++i) {
      const double t = sample(i);
      const glm::dvec3 p = evaluate_patch(patches[a], along_u ? t : ua, along_u ? va : t).position;
      const glm::dvec3 q = evaluate_patch(patches[b], along_u ? t : ub, along_u ? vb : t).position;
      EXPECT_EQ(p, q) << "patches " << a << " and " << b << " at " << t;
    }
  };
  for (int part = 0; part < revolved_parts; ++part)
    for (int quarter = 0; quarter < 4; ++quarter)
      expect_joined(4 * part + quarter, 1, 0, 4 * part + (quarter + 1) % 4, 0, 0, false);
  for (int part = 0; part < tube_parts; ++part)
    for (const double side : {0.0, 1.0})
      expect_joined(tubes_first + 2 * part, side, 0, tubes_first + 2 * part + 1, side, 0, false);
  // One above the other: rim and body, the body's halves, body and bottom, knob and lid; then handle and spout.
  for (const auto& [upper, lower] : {std::pair{0, 4}, {4, 8}, {8, bottom_first}, {12, 16}})
    for (int quarter = 0; quarter < 4; ++quarter) expect_joined(upper + quarter, 0, 1, lower + quarter, 0, 0, true);
  for (const auto& [first, second] : {std::pair{24, 26}, {25, 27}, {28, 30}, {29, 31}})
    expect_joined(first, 0, 1, second, 0, 0, true);
}

TEST(TeapotPatches, NormalsPointOutwards) {
  const auto& patches = teapot_patches();
  for (int number = 0; number < 32; ++number)
    for (int i = 0; i <= samples; ++i)
      for (int j = 0; j <= samples; ++j) {
        const BezierPatch& patch = patches[number];
        const double u = sample(i), v = sample(j);
        const SurfacePoint point = evaluate_patch(patch, u, v);
        ASSERT_NEAR(glm::length(point.normal), 1, 1e-15) << "patch " << number << " at " << u << ", " << v;
        glm::dvec3 core(0, 0, point.position.z);  // what the surface turns its back to
        if (number < 4)
          core = 1.42 * glm::normalize(glm::dvec3(point.position.x, point.position.y, 0)) + glm::dvec3(0, 0, 2.4);
        if (number >= tubes_first) {
          // The middle of the tube's section, between the curves where it meets the plane of symmetry.
          core = 0.5 * (evaluate_patch(patch, 0, v).position + evaluate_patch(patch, 1, v).position);
          // A tube may flare more than it curves, and the spout turns inwards behind its lip: the middle of the first
          // section tells the side, and from there the normals go on without a jump.
          const glm::dvec3 next_u = evaluate_patch(patch, std::min(1.0, u + 1.0 / samples), v).normal;
          const glm::dvec3 next_v = evaluate_patch(patch, u, std::min(1.0, v + 1.0 / samples)).normal;
          ASSERT_GT(glm::dot(point.normal, next_u), 0) << "patch " << number << " at " << u << ", " << v;
          ASSERT_GT(glm::dot(point.normal, next_v), 0) << "patch " << number << " at " << u << ", " << v;
          if (i != samples / 2 || j != 0) continue;
        }
        const double outwards = glm::dot(point.normal, point.position - core);
        ASSERT_GE(outwards, -1e-12) << "patch " << number << " at " << u << ", " << v;
      }
}

TEST(TeapotPatches, PolesHaveTheNormalOfTheAxis) {
  for (int quarter = 0; quarter < 4; ++quarter)
    for (int i = 0; i <= samples; ++i) {
      const glm::dvec3 top = evaluate_patch(teapot_patches()[12 + quarter], sample(i), 0).normal;
      const glm::dvec3 bottom = evaluate_patch(teapot_patches()[bottom_first + quarter], sample(i), 1).normal;
      EXPECT_NEAR(top.z, 1, 1e-15) << "quarter " << quarter << " at " << sample(i);
      EXPECT_NEAR(bottom.z, -1, 1e-15) << "quarter " << quarter << " at " << sample(i);
    }
}

TEST(Teapot, IsSymmetricAndHasGlutsSize) {
  const Box box = box_of(make_teapot({10, 10}).positions);
  EXPECT_EQ(box.lower, glm::dvec3(-1.5, -0.75, -1));
  EXPECT_NEAR(box.upper.x, 1.7171, 0.001);
  EXPECT_EQ(box.upper.y, static_cast<double>(0.825f));
  EXPECT_EQ(box.upper.z, 1);
}

constexpr int spout_patches = 4;
std::size_t patch_triangles(int segments) { return 32u * 2 * segments * segments - 8u * segments; }
std::size_t ring_triangles(int segments) { return 4 * 2u * segments; }
std::size_t closing_triangles(int segments) { return ring_triangles(segments) + 2 * 2u * (segments - 1); }

TEST(Teapot, IsWoundLikeItsNormals) {
  const int segments = 6;
  const Mesh mesh = make_teapot({segments, segments});
  validate(mesh);
  EXPECT_EQ(mesh.positions.size(), 36u * 49);
  const std::size_t closing = patch_triangles(segments), inside_out = closing + closing_triangles(segments);
  EXPECT_EQ(mesh.triangles.size(), inside_out + spout_patches * 72)
      << "the poles of knob and bottom have one triangle a quad";
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const glm::uvec3& t = mesh.triangles[i];
    const glm::dvec3 a(mesh.positions[t.x]), b(mesh.positions[t.y]), c(mesh.positions[t.z]);
    const glm::dvec3 area = glm::cross(b - a, c - a);
    EXPECT_GT(glm::length(area), 1e-7) << "triangle " << i;
    if (i >= closing && i < closing + ring_triangles(segments)) {
      EXPECT_EQ(area.x, 0) << "triangle " << i;
      EXPECT_EQ(area.z, 0) << "triangle " << i;
      EXPECT_GT(area.y, 0) << "triangle " << i;
    } else if (i < closing || i >= inside_out) {
      EXPECT_GT(glm::dot(area, glm::dvec3(mesh.normals[t.x] + mesh.normals[t.y] + mesh.normals[t.z])), 0)
          << "triangle " << i;
    }
  }
}

// Without gaps: but for the inner side of the spout, the only edges that lie on one triangle alone are the spout's
// ends.
TEST(Teapot, IsOpenOnlyAtTheEndsOfItsSpout) {
  for (const int segments : {2, 4, 7}) {
    Mesh mesh = make_teapot({segments, segments});
    mesh.triangles.resize(patch_triangles(segments) + closing_triangles(segments));
    const auto edges = testing::directed_edges(testing::weld(mesh.positions, mesh.triangles));
    int open = 0;
    for (const auto& [edge, count] : edges) {
      EXPECT_EQ(count, 1) << edge[0] << "-" << edge[1];
      if (!edges.contains({edge[1], edge[0]})) ++open;
    }
    EXPECT_EQ(open, 2 * 2 * segments);
  }
}

TEST(Teapot, EndsWithItsSpoutInsideOut) {
  const int segments = 5;
  const Mesh mesh = make_teapot({segments, segments});
  const std::size_t vertices = 36, triangles = 2u * segments * segments;
  for (std::size_t i = 0; i < spout_patches * vertices; ++i) {
    const std::size_t outer = 28 * vertices + i, inner = 32 * vertices + i;
    EXPECT_EQ(mesh.positions[inner], mesh.positions[outer]);
    EXPECT_EQ(mesh.normals[inner], -mesh.normals[outer]);
  }
  const std::size_t first_inner = mesh.triangles.size() - spout_patches * triangles;
  const std::size_t first_outer = patch_triangles(segments) - spout_patches * triangles;
  const glm::uint shift = 4 * vertices;
  for (std::size_t i = 0; i < spout_patches * triangles; ++i) {
    const glm::uvec3 outer = mesh.triangles[first_outer + i] + shift;
    EXPECT_EQ(mesh.triangles[first_inner + i], glm::uvec3(outer.x, outer.z, outer.y)) << "triangle " << i;
  }
}

}  // namespace
}  // namespace morphcl
