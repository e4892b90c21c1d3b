#include "host/geometry/morph_tree.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "morphcl/solids.hpp"

namespace morphcl {
namespace {

// The sphere to a cube, and a second target that adds to it.
Mesh morphing_mesh() {
  Mesh mesh = make_sphere_to_cube({40, 30});
  MorphTarget& lifted = mesh.targets.emplace_back();
  lifted.name = "lifted";
  for (const glm::vec3& position : mesh.positions) lifted.positions.push_back(0.1f * position + glm::vec3(0, 1, 0));
  mesh.targets.emplace_back().name = "nothing";
  return mesh;
}

// What every vertex reaches, without the tree.
double reach_of_all(const Mesh& mesh, const std::vector<double>& weights, const glm::dvec3& direction) {
  double farthest = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const glm::dvec3 base(mesh.positions[i]), cube(mesh.targets[0].positions[i]), lift(mesh.targets[1].positions[i]);
    farthest = std::max(farthest, glm::dot(base + weights[0] * (cube - base) + weights[1] * lift, direction));
  }
  return farthest;
}

TEST(MorphTree, FindsTheFarthestVertexUnderAnyWeights) {
  const Mesh mesh = morphing_mesh();
  const MorphTree tree(mesh, drawn_vertices(mesh, false));
  for (const double weight : {-1.0, 0.0, 0.3, 1.0, 4.0})
    for (const double angle : {0.0, 1.0, 2.0, 3.0, 4.0, 5.0}) {
      const std::vector<double> weights = {weight, 0.5 - weight, 1};
      const glm::dvec3 direction(std::cos(angle), std::sin(angle), std::sin(3 * angle));
      const double expected = reach_of_all(mesh, weights, direction);
      const auto found = tree.farthest(weights, direction, -std::numeric_limits<double>::infinity());
      ASSERT_TRUE(found);
      EXPECT_DOUBLE_EQ(found->distance, expected) << "weight " << weight << ", angle " << angle;
      EXPECT_EQ(found->distance, glm::dot(morphed_vertex(mesh, weights, found->vertex), direction));
      EXPECT_FALSE(tree.farthest(weights, direction, expected + 1e-9));
    }
}

TEST(MorphTree, OfNothingFindsNothing) {
  const Mesh mesh = morphing_mesh();
  EXPECT_FALSE(
      MorphTree(mesh, {}).farthest(std::vector<double>(3, 0.0), {1, 0, 0}, -std::numeric_limits<double>::infinity()));
}

TEST(DrawnVertices, AreThoseThatAreNamed) {
  Mesh mesh;
  mesh.positions.assign(6, glm::vec3(0));
  mesh.triangles = {{4, 1, 2}, {2, 1, 4}};
  EXPECT_EQ(drawn_vertices(mesh, false), (std::vector<std::uint32_t>{1, 2, 4}));
  EXPECT_EQ(drawn_vertices(mesh, true), (std::vector<std::uint32_t>{1, 2, 4}));
  mesh.edges = {{5, 0}};
  EXPECT_EQ(drawn_vertices(mesh, false), (std::vector<std::uint32_t>{1, 2, 4}));
  EXPECT_EQ(drawn_vertices(mesh, true), (std::vector<std::uint32_t>{0, 5}));
}

}  // namespace
}  // namespace morphcl
