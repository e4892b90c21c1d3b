// The key `morph_to`: meshes of equal topology as morph targets.
#include <gtest/gtest.h>

#include <string>

#include "morphcl/solids.hpp"
#include "tests/scene/shot_folder.hpp"

namespace morphcl {
namespace {

using test::ShotFolder;

TEST(ShotMorphTo, GivesTheObjectTargetsWithTheShapesOfSolids) {
  const Scene scene = ShotFolder().load(R"(
[[object]]
mesh = "cylinder"
segments = [12, 3]
morph_to = ["cone", { mesh = "cylinder", segments = [12, 3], name = "back" }]
[[object.track]]
target = "morph.cone"
keys = [[0, 0], [10, 1]]
[[object]]
mesh = "cylinder"
segments = [12, 3]
)");
  ASSERT_EQ(scene.meshes.size(), 2u);  // one with targets, and one without
  const Mesh& mesh = scene.meshes[static_cast<std::size_t>(scene.objects[0].mesh)];
  const Mesh cone = make_cone({12, 3});
  ASSERT_EQ(mesh.targets.size(), 2u);
  EXPECT_EQ(mesh.targets[0].name, "cone");
  EXPECT_EQ(mesh.targets[0].form, TargetForm::absolute);
  EXPECT_EQ(mesh.targets[0].positions, cone.positions);
  EXPECT_EQ(mesh.targets[0].normals, cone.normals);
  EXPECT_EQ(mesh.targets[1].name, "back");
  EXPECT_EQ(weights_at(scene.objects[0].morph, scene.timeline.time, 5), (std::vector<double>{0.5, 0}));
}

TEST(ShotMorphTo, GoesFromFilesToFilesAndSolids) {
  const ShotFolder folder;
  folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  folder.write("tall.obj", "v 0 0 0\nv 1 0 0\nv 0 9 0\nf 1 2 3\n");
  const Scene scene = folder.load("[[object]]\nmesh = \"a.obj\"\nmorph_to = [\"tall.obj\"]");
  ASSERT_EQ(scene.meshes[0].targets.size(), 1u);
  EXPECT_EQ(scene.meshes[0].targets[0].name, "tall");
  EXPECT_EQ(scene.meshes[0].targets[0].positions[2], glm::vec3(0, 9, 0));
  EXPECT_EQ(scene.inputs.size(), 3u);  // all files are known, so that frames do not overwrite them
}

TEST(ShotMorphTo, SurfacesOfRevolutionMorphIntoEachOther) {
  const Scene scene = ShotFolder().load(R"(
[[object]]
mesh = "revolution"
profile = [[0, 1], [1, 0], [0, -1]]
morph_to = [{ mesh = "revolution", profile = [[0, 2], [3, 0], [0, -2]], name = "large" }]
)");
  ASSERT_EQ(scene.meshes[0].targets.size(), 1u);
  EXPECT_EQ(scene.meshes[0].targets[0].name, "large");
}

TEST(ShotMorphTo, AnotherTopologyIsRefusedWithBothCounts) {
  const ShotFolder folder;
  const std::string sphere = "[[object]]\nmesh = \"sphere\"\nsegments = [8, 4]\nmorph_to = ";
  EXPECT_EQ(folder.refusal(sphere + "[\"torus\"]"),
            "shot.toml:4:13: \"torus\" has 45 vertices, 64 triangles and 0 edges, and \"sphere\", which would morph to "
            "it, 45, 48 and 0; a morph needs the same topology");
  EXPECT_EQ(
      folder.refusal(sphere + "[{ mesh = \"sphere\", segments = [8, 5] }]"),
      "shot.toml:4:13: \"sphere\" has 54 vertices, 64 triangles and 0 edges, and \"sphere\", which would morph to "
      "it, 45, 48 and 0; a morph needs the same topology");
  EXPECT_EQ(folder.refusal("[[object]]\nmesh = \"grid\"\nsegments = [3, 7]\nmorph_to = [{ mesh = \"grid\", segments = "
                           "[7, 3] }]"),
            "shot.toml:4:13: \"grid\" has as many vertices and triangles as \"grid\", but triangle 0 joins others; a "
            "morph needs the same topology");
}

TEST(ShotMorphTo, WhatIsWrongIsRefusedWithItsPlace) {
  const ShotFolder folder;
  const std::string cube = "[[object]]\nmesh = \"pyramid_to_cube\"\nmorph_to = ";
  EXPECT_EQ(folder.refusal(cube + "[{ mesh = \"pyramid_to_cube\", name = \"cube\" }]"),
            "shot.toml:3:13: there are two morph targets \"cube\"; name one: { mesh = \"...\", name = \"...\" }");
  EXPECT_EQ(folder.refusal(cube + "[\"cub\"]"),
            "shot.toml:3:13: morph_to \"cub\": a built-in solid, a .gltf, .glb or .obj file, or a table with the key "
            "mesh is needed");
  EXPECT_EQ(folder.refusal(cube + "\"cube\""), "shot.toml:3:12: morph_to is a string; an array is needed");
  EXPECT_EQ(folder.refusal(cube + "[\"b.obj\"]"), "cannot read: shot.toml:3:13: there is no file \"b.obj\"");
}

}  // namespace
}  // namespace morphcl
