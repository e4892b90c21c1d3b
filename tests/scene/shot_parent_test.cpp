// The key `parent` of objects, lights and the camera: what it does to matrices, and every way to write it wrongly.
#include <gtest/gtest.h>

#include <string>

#include "morphcl/camera.hpp"
#include "morphcl/transform.hpp"
#include "tests/scene/shot_folder.hpp"

namespace morphcl {
namespace {

using test::ShotFolder;

constexpr std::string_view arm_and_hand = R"(
[[object]]
name = "hand"
mesh = "sphere"
segments = [3, 2]
parent = "arm"
[[object.transform]]
translate = [0, 2, 0]
[[object]]
name = "arm"
mesh = "cube"
parent = "base"
[[object.transform]]
scale = [2, 3, 4]
[[object.track]]
target = "rotation"
keys = [[0, { axis = [0, 0, 1], degrees = 0 }], [10, { axis = [0, 0, 1], degrees = 90 }]]
[[object]]
name = "base"
mesh = "none"
[[object.transform]]
translate = [10, 0, 0]
[[object.track]]
target = "visible"
keys = [[0, true], [20, false]]
)";

glm::dmat4 to_world(const Scene& scene, std::size_t object, std::int64_t frame) {
  return evaluate(scene.timeline, frame).node_to_world[static_cast<std::size_t>(scene.objects[object].node)];
}

TEST(ShotParent, PointsGoThroughOwnTransformThenTheParents) {
  const Scene scene = ShotFolder().load(arm_and_hand);
  ASSERT_EQ(scene.objects.size(), 2u);  // a group draws nothing
  const glm::dmat4 hand = CompositeTransform().translate({0, 2, 0}).matrix(),
                   arm = CompositeTransform().scale({2, 3, 4}).matrix(),
                   base = CompositeTransform().translate({10, 0, 0}).matrix(),
                   turn = CompositeTransform().rotate_z_degrees(90).matrix();
  EXPECT_EQ(to_world(scene, 0, 0), base * arm * hand);
  const glm::dvec4 held = to_world(scene, 0, 10) * glm::dvec4(0, 0, 0, 1), expected = base * turn * arm * hand[3];
  for (int i = 0; i < 4; ++i) EXPECT_NEAR(held[i], expected[i], 1e-14) << i;  // 8u64 of 10
  EXPECT_NEAR(held.x, 4, 1e-14);
}

TEST(ShotParent, WhatHidesTheParentHidesWhatHangsBelow) {
  const Scene scene = ShotFolder().load(arm_and_hand);
  const auto node = static_cast<std::size_t>(scene.objects[0].node);
  EXPECT_NE(evaluate(scene.timeline, 19).node_visible[node], 0);
  EXPECT_EQ(evaluate(scene.timeline, 20).node_visible[node], 0);
}

TEST(ShotParent, CameraAndLightsMoveWithTheirs) {
  const Scene scene = ShotFolder().load(R"(
light = [
  { direction = [0, 1, 0], parent = "cart" }, { position = [0, 1, 0], parent = "cart" }, { direction = [0, 1, 0] }
]
[camera]
eye = [0, 0, 2]
target = [0, 0, 0]
parent = "cart"
[[object]]
name = "cart"
mesh = "cube"
[[object.transform]]
scale = [3, 3, 3]
[[object.transform]]
rotate_z_degrees = 90
[[object.track]]
target = "translation"
keys = [[0, [0, 0, 0]], [10, [5, 0, 0]]]
)");
  const FrameState state = evaluate(scene.timeline, 10);
  const glm::dmat4 expected = look_at({5, 0, 6}, {5, 0, 0}, {-1, 0, 0}).world_to_eye;
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 4; ++row) EXPECT_NEAR(state.camera.world_to_eye[column][row], expected[column][row], 1e-15);
  EXPECT_EQ(state.lights[0].vector, glm::dvec3(-1, 0, 0));  // of unit length, whatever the scale
  EXPECT_EQ(state.lights[1].vector, glm::dvec3(2, 0, 0));
  EXPECT_EQ(state.lights[2].vector, glm::dvec3(0, 1, 0));
}

TEST(ShotParent, CarriedCameraWhoseUpIsOfNoUseSaysSo) {
  const Scene scene = ShotFolder().load(R"(
[camera]
eye = [0, 0, 2]
up = [0, 1, 0]
parent = "flat"
[[object]]
name = "flat"
mesh = "cube"
[[object.transform]]
scale = [1, 0, 1]
)");
  ASSERT_EQ(scene.warnings.size(), 1u);
  EXPECT_NE(scene.warnings[0].find("up lies along the view"), std::string::npos) << scene.warnings[0];
}

TEST(ShotParent, WhatIsWrongIsRefusedWithItsPlace) {
  const ShotFolder folder;
  const std::string cube = "[[object]]\nmesh = \"cube\"\n";
  EXPECT_EQ(folder.refusal(cube + "parent = \"arm\""),
            "shot.toml:3:10: no object has the name \"arm\"; give the parent its name");
  EXPECT_EQ(folder.refusal(cube + "name = \"arms\"\n" + cube + "parent = \"arm\""),
            "shot.toml:6:10: no object has the name \"arm\"; did you mean \"arms\"?");
  EXPECT_EQ(folder.refusal(cube + "name = \"a\"\nparent = \"a\""),
            "shot.toml:4:10: \"a\" below \"a\": an object cannot hang below itself; leave one parent out");
  EXPECT_EQ(folder.refusal(cube + "name = \"a\"\nparent = \"b\"\n" + cube + "name = \"b\"\nparent = \"c\"\n" + cube +
                           "name = \"c\"\nparent = \"b\""),
            "shot.toml:4:10: \"b\" below \"c\" below \"b\": an object cannot hang below itself; leave one parent out");
  EXPECT_EQ(folder.refusal(cube + "parent = 3"), "shot.toml:3:10: parent is an integer; a string is needed");
  EXPECT_EQ(
      folder.refusal("[camera]\nparent = \"a\"\n" + cube + "name = \"a\""),
      "shot.toml:2:10: a fitted camera stands still in the world; say by eye and target where it stands below its "
      "parent");
  EXPECT_EQ(
      folder.refusal("[camera]\nparent = \"a\"\neye = [0, 0, 9]\nmark_vanishing_points = true\n" + cube +
                     "name = \"a\""),
      "shot.toml:2:10: vanishing points can be marked for a camera that stands in the world; this one has a parent");
  EXPECT_EQ(folder.refusal("[[light]]\ndirection = [1, 0, 0]\nparent = \"b\"\n" + cube + "name = \"a\""),
            "shot.toml:3:10: no object has the name \"b\"; known: a");
}

TEST(ShotParent, GroupHasNothingToDraw) {
  const ShotFolder folder;
  const std::string group = "[[object]]\nmesh = \"none\"\n";
  EXPECT_EQ(folder.refusal(group),
            "shot.toml:1:1: a group, mesh = \"none\", needs a name that others have as their parent");
  EXPECT_EQ(folder.refusal(group + "name = \"g\"\ncolor = [1, 1, 1]"),
            "shot.toml:4:9: a group, mesh = \"none\", draws nothing; it has no color");
  EXPECT_EQ(folder.refusal(group + "name = \"g\"\n[[object.track]]\ntarget = \"morph.a\"\nkeys = [[0, 1]]"),
            "shot.toml:5:10: morph.a: the mesh has no morph targets");
}

TEST(ShotParent, DeepChainsAreReadInLinearTime) {
  std::string shot;
  constexpr int links = 5000;
  for (int i = 0; i < links; ++i)
    shot += "[[object]]\nmesh = \"none\"\nname = \"" + std::to_string(i) + "\"\n" +
            (i + 1 < links ? "parent = \"" + std::to_string(i + 1) + "\"\n" : "") +
            "[[object.transform]]\ntranslate = [1, 0, 0]\n";
  shot += "[[object]]\nmesh = \"cube\"\nparent = \"0\"\n";
  const Scene scene = ShotFolder().load(shot);
  EXPECT_EQ(to_world(scene, 0, 0)[3], glm::dvec4(links, 0, 0, 1));
}

}  // namespace
}  // namespace morphcl
