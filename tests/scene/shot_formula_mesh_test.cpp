// Surfaces of revolution and curves in shots.
#include <gtest/gtest.h>

#include <string>

#include "morphcl/solids.hpp"
#include "tests/scene/shot_folder.hpp"

namespace morphcl {
namespace {

using test::ShotFolder;

std::string revolution(std::string_view rest) { return "[[object]]\nmesh = \"revolution\"\n" + std::string(rest); }
std::string curve(std::string_view rest) { return "[[object]]\nmesh = \"curve\"\n" + std::string(rest); }

TEST(ShotFormulaMesh, RevolutionTurnsItsProfile) {
  const Scene scene = ShotFolder().load(revolution("profile = [[0, 1], [1, 0], [0, -1]]\nsegments = [8, 2]"));
  const std::vector<glm::dvec2> cut = {{0, 1}, {0.5, 0.5}, {1, 0}, {0.5, -0.5}, {0, -1}};
  EXPECT_EQ(scene.meshes[0].positions, make_revolution(cut, 8).positions);
  EXPECT_EQ(scene.meshes[0].triangles, make_revolution(cut, 8).triangles);
}

TEST(ShotFormulaMesh, CurveIsDrawnAsLines) {
  const Scene scene = ShotFolder().load(curve("points = [[0, 0, 0], { polar = [1, 90] }, [2, 0, 0]]"));
  EXPECT_EQ(scene.objects[0].material.shading, Shading::wireframe);
  EXPECT_EQ(scene.meshes[0].edges.size(), 20u);
  EXPECT_EQ(scene.meshes[0].positions[10], glm::vec3(0, 1, 0));
}

TEST(ShotFormulaMesh, DifferentFormulasAreDifferentMeshesAndEqualOnesAreShared) {
  const std::string first = curve("points = [[0, 0, 0], [1, 0, 0]]\n"),
                    second = curve("points = [[0, 0, 0], [2, 0, 0]]\n");
  EXPECT_EQ(ShotFolder().load(first + second + first).meshes.size(), 2u);
}

TEST(ShotFormulaMesh, WhatIsWrongIsRefusedWithItsPlace) {
  const ShotFolder folder;
  EXPECT_EQ(folder.refusal(revolution("")), "shot.toml:1:1: object needs the key \"profile\"");
  EXPECT_EQ(folder.refusal(revolution("profile = [[1, 0]]")),
            "shot.toml:3:11: a profile of 1 points; two or more are needed");
  EXPECT_EQ(folder.refusal(revolution("profile = [[1, 0], [-1, 0]]")),
            "shot.toml:3:21: the radius is -1; 0 or more is needed");
  EXPECT_EQ(folder.refusal(revolution("profile = [[0, 0], [0, 1]]")),
            "shot.toml:3:11: the profile sweeps no area; it needs a piece that is not on the axis");
  EXPECT_EQ(folder.refusal(revolution("profile = [[1, 0], [1, 0, 0]]")),
            "shot.toml:3:20: profile must be a list of points [radius, y], downwards on the outside");
  EXPECT_EQ(folder.refusal(revolution("profile = [[1, 0], [1, 1]]\nsegments = [2, 1]")),
            "shot.toml:3:11: 2 pieces around; 3 or more are needed");
  EXPECT_EQ(folder.refusal(curve("points = [[0, 0, 0]]")),
            "shot.toml:3:10: a curve through 1 points; two or more are needed");
  EXPECT_EQ(folder.refusal(curve("points = [[0, 0, 0], [1, 0, 0]]\nshading = \"flat\"")),
            "shot.toml:4:11: a curve is drawn as lines: its shading is \"wireframe\"");
  EXPECT_EQ(folder.refusal(curve("points = [[0, 0, 0], [1, 0, 0]]\nsegments = [3, 3]")),
            "shot.toml:4:12: a curve has segments in one direction: [u, 1]");
  EXPECT_EQ(folder.refusal("[[object]]\nmesh = \"cube\"\nprofile = [[1, 0]]"),
            "shot.toml:3:11: profile belongs to the mesh \"revolution\"");
  EXPECT_EQ(folder.refusal("[[object]]\nmesh = \"cube\"\npoints = [[1, 0, 0]]"),
            "shot.toml:3:10: points belong to the mesh \"curve\"");
}

}  // namespace
}  // namespace morphcl
