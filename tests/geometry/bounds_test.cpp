#include "host/geometry/bounds.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "morphcl/error.hpp"
#include "morphcl/solids.hpp"

namespace morphcl {
namespace {

TEST(Box, StartsEmptyAndGrows) {
  Box box;
  EXPECT_TRUE(box.empty());
  box.include(glm::dvec3(1, 2, 3));
  EXPECT_FALSE(box.empty());
  box.include(glm::dvec3(-1, 5, 3));
  EXPECT_EQ(box.lower, glm::dvec3(-1, 2, 3));
  EXPECT_EQ(box.upper, glm::dvec3(1, 5, 3));
  EXPECT_EQ(box.corner(0), box.lower);
  EXPECT_EQ(box.corner(7), box.upper);
  EXPECT_TRUE(box.contains({0, 2, 3}));
  EXPECT_FALSE(box.contains({0, 2, 3.5}));
}

TEST(Box, TransformedContainsItsImage) {
  const Box box{{-1, -2, -3}, {1, 2, 3}};
  const glm::dmat4 quarter_about_z({0, 1, 0, 0}, {-1, 0, 0, 0}, {0, 0, 1, 0}, {10, 0, 0, 1});
  const Box turned = transformed(box, quarter_about_z);
  EXPECT_EQ(turned.lower, glm::dvec3(8, -1, -3));
  EXPECT_EQ(turned.upper, glm::dvec3(12, 1, 3));
  EXPECT_TRUE(transformed(Box{}, quarter_about_z).empty());
}

TEST(Sphere, HoldsTheBox) {
  const Sphere sphere = sphere_of({{-1, -2, -2}, {3, 2, 2}});
  EXPECT_EQ(sphere.center, glm::dvec3(1, 0, 0));
  EXPECT_EQ(sphere.radius, std::sqrt(12.0));
}

TEST(MorphBounds, OfOneAbsoluteTargetAreThoseBetweenBothShapes) {
  const Mesh mesh = make_pyramid_to_cube();
  const MorphBounds bounds(mesh);
  // The widening: (1 target + 2) ulp of at most 150 + 1 (50 + 150 + 150).
  const double margin = 3 * std::ldexp(1.0, -23) * 500;
  for (const double weight : {0.0, 0.37, 1.0}) {
    const Box box = bounds.at(std::vector<double>{weight});
    EXPECT_NEAR(box.lower.x, 50, margin) << weight;
    EXPECT_NEAR(box.upper.x, 150, margin) << weight;
    EXPECT_NEAR(box.lower.z, 30, margin) << weight;
    EXPECT_NEAR(box.upper.z, 100, margin) << weight;
  }
}

TEST(MorphBounds, AsksForOneWeightATarget) {
  try {
    MorphBounds(make_pyramid_to_cube()).at(std::vector<double>{});
    FAIL() << "was accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::internal);
  }
}

// Random meshes with targets of both forms, some without positions.
Mesh random_mesh(std::mt19937& random, int vertices) {
  std::uniform_real_distribution<float> coordinate(-10, 10);
  const auto point = [&] { return glm::vec3{coordinate(random), coordinate(random), coordinate(random)}; };
  Mesh mesh;
  for (int i = 0; i < vertices; ++i) mesh.positions.push_back(point());
  for (int t = 0; t < 5; ++t) {
    MorphTarget target;
    target.form = t % 2 ? TargetForm::absolute : TargetForm::delta;
    for (std::size_t i = 0; i < mesh.positions.size() && t != 2; ++i) target.positions.push_back(point());
    mesh.targets.push_back(target);
  }
  return mesh;
}

// The morph as a renderer does it, in fp32.
glm::vec3 morphed(const Mesh& mesh, std::size_t vertex, const std::vector<double>& weights) {
  glm::vec3 p = mesh.positions[vertex];
  for (std::size_t t = 0; t < weights.size(); ++t) {
    const MorphTarget& target = mesh.targets[t];
    if (target.positions.empty()) continue;
    const auto weight = static_cast<float>(weights[t]);
    if (target.form == TargetForm::absolute) p -= weight * mesh.positions[vertex];
    p += weight * target.positions[vertex];
  }
  return p;
}

TEST(MorphBounds, ContainEveryVertexForWeightsOfAnySign) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> any_weight(-2, 3);
  for (int round = 0; round < 200; ++round) {
    // The bounds of a single vertex are a point but for the rounding of the renderer's sum.
    const Mesh mesh = random_mesh(random, round % 2 ? 20 : 1);
    const MorphBounds bounds(mesh);
    std::vector<double> weights;
    std::vector<Interval> around;
    for (std::size_t t = 0; t < mesh.targets.size(); ++t) {
      weights.push_back(round % 3 == 0 ? 0.0 : any_weight(random));
      around.push_back({weights[t] - 0.5, weights[t] + 0.25});
    }
    const Box exact = bounds.at(weights), wide = bounds.at(around);
    EXPECT_TRUE(wide.contains(exact.lower) && wide.contains(exact.upper)) << "round " << round;
    for (std::size_t i = 0; i < mesh.positions.size(); ++i)
      ASSERT_TRUE(exact.contains(glm::dvec3(morphed(mesh, i, weights)))) << "round " << round << ", vertex " << i;
  }
}

}  // namespace
}  // namespace morphcl
