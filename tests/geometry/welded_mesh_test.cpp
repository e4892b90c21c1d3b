#include "host/geometry/welded_mesh.hpp"

#include <gtest/gtest.h>

#include <set>

#include "morphcl/solids.hpp"

namespace morphcl {
namespace {

TEST(WeldedMesh, ACubeHasEightCorners) {
  const Mesh cube = make_cube();
  const WeldedMesh welded = weld(cube);
  ASSERT_EQ(welded.vertex_of_point.size(), 8u);
  EXPECT_EQ(welded.edges.size(), 12u + 6u) << "and a diagonal a face";
  for (std::size_t i = 0; i < cube.positions.size(); ++i)
    EXPECT_EQ(cube.positions[welded.vertex_of_point[welded.point_of_vertex[i]]], cube.positions[i]);
}

TEST(WeldedMesh, VerticesThatTargetsPartAreTwoPoints) {
  const WeldedMesh welded = weld(make_pyramid_to_cube());
  EXPECT_EQ(welded.vertex_of_point.size(), 8u) << "the apex is four points";
}

TEST(WeldedMesh, SeamsAndPolesAreClosed) {
  const Mesh sphere = make_sphere({12, 6});
  const WeldedMesh welded = weld(sphere);
  // Sines of a full turn are exact, so the seam's vertices have the same positions; each pole is one point.
  EXPECT_EQ(welded.vertex_of_point.size(), 12u * 5u + 2u);
  std::set<std::pair<unsigned, unsigned>> edges;
  for (const glm::uvec2& edge : welded.edges) {
    EXPECT_LT(edge.x, edge.y);
    edges.emplace(edge.x, edge.y);
  }
  EXPECT_EQ(edges.size(), welded.edges.size());
  EXPECT_EQ(welded.edges.size(), 3u * welded.vertex_of_point.size() - 6u) << "Euler's formula for a closed surface";
}

TEST(WeldedMesh, LinesServeWhereThereAreNoTriangles) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {-0.0f, 0, 0}, {2, 0, 0}};
  mesh.edges = {{0, 1}, {1, 2}, {1, 3}, {0, 2}};
  const WeldedMesh welded = weld(mesh);
  EXPECT_EQ(welded.point_of_vertex, (std::vector<std::uint32_t>{0, 1, 0, 2}));
  EXPECT_EQ(welded.edges, (std::vector<glm::uvec2>{{0, 1}, {1, 2}}));
}

}  // namespace
}  // namespace morphcl
