#include "morphcl/mesh.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "morphcl/error.hpp"

namespace morphcl {
namespace {

Mesh triangle() {
  Mesh mesh;
  mesh.name = "one";
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}};
  return mesh;
}

struct Broken {
  const char* what;
  std::function<void(Mesh&)> how;
  const char* message;
};

void PrintTo(const Broken& broken, std::ostream* out) { *out << broken.what; }

class BrokenMesh : public ::testing::TestWithParam<Broken> {};

TEST_P(BrokenMesh, IsRefusedWithArrayAndElement) {
  Mesh mesh = triangle();
  validate(mesh);
  GetParam().how(mesh);
  try {
    validate(mesh);
    FAIL() << "was accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::bad_input);
    EXPECT_EQ(error.message(), std::string("mesh \"one\": ") + GetParam().message);
  }
}

constexpr float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();

INSTANTIATE_TEST_SUITE_P(
    All, BrokenMesh,
    ::testing::Values(
        Broken{"Empty",
               [](Mesh& m) {
                 m.positions.clear();
                 m.triangles.clear();
               },
               "positions is empty; a mesh needs at least one vertex"},
        Broken{"NanPosition", [](Mesh& m) { m.positions[1].y = nan; },
               "positions[1] holds nan; every component must be finite"},
        Broken{"InfinitePosition", [](Mesh& m) { m.positions[2].z = -infinity; },
               "positions[2] holds -inf; every component must be finite"},
        Broken{"ShortNormals", [](Mesh& m) { m.normals.resize(2, glm::vec3(0, 0, 1)); },
               "normals has 2 elements; one for each of the 3 vertices is needed"},
        Broken{"LongColors", [](Mesh& m) { m.colors.resize(4, glm::vec4(1)); },
               "colors has 4 elements; one for each of the 3 vertices is needed"},
        Broken{"ShortUvs", [](Mesh& m) { m.uvs.resize(2); },
               "uvs has 2 elements; one for each of the 3 vertices is needed"},
        Broken{"InfiniteUv", [](Mesh& m) { m.uvs = {{0, 0}, {0, infinity}, {1, 1}}; },
               "uvs[1] holds inf; every component must be finite"},
        Broken{"NanNormal", [](Mesh& m) { m.normals = {{0, 0, 1}, {0, 0, 1}, {nan, 0, 0}}; },
               "normals[2] holds nan; every component must be finite"},
        Broken{"TriangleIndex", [](Mesh& m) { m.triangles.push_back({0, 1, 3}); },
               "triangles[1] names vertex 3; there are 3 vertices, counted from 0"},
        Broken{"EdgeIndex", [](Mesh& m) { m.edges = {{0, 4000000000u}}; },
               "edges[0] names vertex 4000000000; there are 3 vertices, counted from 0"},
        Broken{"ShortTarget", [](Mesh& m) { m.targets = {{"t", TargetForm::delta, {{0, 0, 0}}, {}, {}}}; },
               "targets[0].positions has 1 elements; one for each of the 3 vertices is needed"},
        Broken{"NanTargetNormal",
               [](Mesh& m) { m.targets = {{}, {"t", TargetForm::delta, {}, {{0, 0, 1}, {0, nan, 1}, {0, 0, 1}}, {}}}; },
               "targets[1].normals[1] holds nan; every component must be finite"}),
    [](const auto& test) { return test.param.what; });

TEST(Edges, AreDistinctSortedAndSmallerIndexFirst) {
  const std::vector<glm::uvec2> expected = {{0, 1}, {0, 2}, {1, 2}, {1, 3}, {2, 3}};
  EXPECT_EQ(distinct_edges({{2, 1, 0}, {3, 2, 1}, {1, 2, 3}}), expected);
}

TEST(Edges, SkipASideBetweenAVertexAndItself) {
  EXPECT_EQ(distinct_edges({{5, 5, 2}}), (std::vector<glm::uvec2>{{2, 5}}));
  EXPECT_TRUE(distinct_edges({}).empty());
}

TEST(Edges, OfTheMeshReplaceThoseOfItsTriangles) {
  Mesh mesh = triangle();
  EXPECT_EQ(wireframe_edges(mesh).size(), 3u);
  mesh.edges = {{2, 0}};
  EXPECT_EQ(wireframe_edges(mesh), mesh.edges);
}

}  // namespace
}  // namespace morphcl
