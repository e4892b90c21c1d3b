// Transform steps and tracks of an object that move: composite transforms over time, and both readings of a step.
#include <gtest/gtest.h>

#include <string>

#include "morphcl/error.hpp"
#include "morphcl/transform.hpp"
#include "tests/scene/shot_folder.hpp"

namespace morphcl {
namespace {

using test::ShotFolder;

std::string cube_with(std::string_view rest) { return "[[object]]\nmesh = \"cube\"\n" + std::string(rest); }

std::string cube_with_step(std::string_view step) { return cube_with("[[object.transform]]\n" + std::string(step)); }

glm::dmat4 at(const Scene& scene, std::int64_t frame) { return evaluate(scene.timeline, frame).node_to_world.back(); }

glm::dmat4 at(std::string_view shot, std::int64_t frame) { return at(ShotFolder().load(shot), frame); }

TEST(ShotMotion, EveryStepMayHaveKeysForItsNumbers) {
  const auto expect = [](const char* step, const CompositeTransform& expected) {
    EXPECT_EQ(at(cube_with_step(step), 5), expected.matrix()) << step;
  };
  expect("translate = [[0, [0, 0, 0]], [10, [2, 4, 6]]]", CompositeTransform().translate({1, 2, 3}));
  expect("scale = [[0, [1, 1, 1]], [10, 5]]", CompositeTransform().scale({3, 3, 3}));
  expect("scale_about = { point = [1, 2, 3], factor = [[0, 1], [10, 3]] }",
         CompositeTransform().scale_about({1, 2, 3}, {2, 2, 2}));
  expect("scale_about = { point = [[0, [0, 0, 0]], [10, [2, 4, 6]]], factor = 2 }",
         CompositeTransform().scale_about({1, 2, 3}, {2, 2, 2}));
  expect("rotate_x_degrees = [[0, 0], [10, 60]]", CompositeTransform().rotate_x_degrees(30));
  expect("rotate_y_degrees = [[0, 0], [10, 60]]", CompositeTransform().rotate_y_degrees(30));
  expect("rotate_z_degrees = [[0, 0], [10, 60]]", CompositeTransform().rotate_z_degrees(30));
  expect("rotate_about_axis = { from = [1, 2, 3], to = [4, 4, 4], degrees = [[0, 0], [10, 80]] }",
         CompositeTransform().rotate_about_axis({1, 2, 3}, {4, 4, 4}, 40));
  expect("rotate_about_axis = { from = [0, 0, 0], to = [[0, [1, 0, 0]], [10, [1, 2, 0]]], degrees = 40 }",
         CompositeTransform().rotate_about_axis({0, 0, 0}, {1, 1, 0}, 40));
  expect("rotate_in_seven_steps = { from = [1, 2, 3], to = [4, 4, 4], degrees = [[0, 0], [10, 80]] }",
         rotation_in_seven_steps({1, 2, 3}, {4, 4, 4}, 40));
  expect("shear = { xy = [[0, 0], [10, 1]], zx = 2 }", CompositeTransform().shear(0.5, 0, 0, 0, 2, 0));
}

TEST(ShotMotion, KeysInATableSayHowTheyAreJoined) {
  const auto degrees = [](const char* keys) {
    return at(cube_with_step(std::string("rotate_z_degrees = ") + keys), 5);
  };
  EXPECT_EQ(degrees("{ keys = [[0, 0], [10, 90]], interpolation = \"step\" }"), glm::dmat4(1.0));
  EXPECT_EQ(degrees("{ keys = [[0, 0, 0, 0], [10, 90, 0, 0]], interpolation = \"cubic\" }"),
            CompositeTransform().rotate_z_degrees(45).matrix());
  const Scene spring = ShotFolder().load(
      cube_with_step("rotate_z_degrees = { keys = [[0, 0], [10, 90]], interpolation = \"spring\", frequency = 1 }"));
  EXPECT_GT(spring.frames[0].last, 10);  // until it has settled
}

// Angles are interpolated, not matrices: many turns, and the pose after each of them bit for bit.
TEST(ShotMotion, TurnsAsManyTimesAsTheKeysSay) {
  const Scene scene = ShotFolder().load(
      cube_with_step("rotate_about_axis = { from = [0, 0, 0], to = [1, 0, 1], degrees = [[0, 0], [1440, 720]] }"));
  EXPECT_EQ(scene.frames[0].last, 1440);
  EXPECT_EQ(at(scene, 720), at(scene, 0));
  EXPECT_EQ(at(scene, 90), CompositeTransform().rotate_about_axis({0, 0, 0}, {1, 0, 1}, 45).matrix());
}

TEST(ShotMotion, StepsThatMoveAndStepsThatDoNotKeepTheirOrder) {
  const Scene scene = ShotFolder().load(cube_with(R"([[object.transform]]
translate = [1, 0, 0]
[[object.transform]]
rotate_z_degrees = [[0, 0], [10, 90]]
[[object.transform]]
scale = 2
)"));
  EXPECT_EQ(at(scene, 10), CompositeTransform().translate({1, 0, 0}).rotate_z_degrees(90).scale({2, 2, 2}).matrix());
}

TEST(ShotMotion, StepsOfTheAxesAreTheInverses) {
  const auto expect = [](const char* step, const CompositeTransform& of_the_object) {
    EXPECT_EQ(at(cube_with_step(std::string(step) + "\nof = \"object\""), 0), of_the_object.matrix()) << step;
    EXPECT_EQ(at(cube_with_step(std::string(step) + "\nof = \"axes\""), 0), of_the_object.inverse().matrix()) << step;
  };
  expect("translate = [1, 2, 3]", CompositeTransform().translate({1, 2, 3}));
  expect("scale = [1, 2, 4]", CompositeTransform().scale({1, 2, 4}));
  expect("scale_about = { point = [1, 1, 1], factor = 2 }", CompositeTransform().scale_about({1, 1, 1}, {2, 2, 2}));
  expect("rotate_x_degrees = 30", CompositeTransform().rotate_x_degrees(30));
  expect("rotate_about_axis = { from = [0, 0, 1], to = [1, 0, 1], degrees = 30 }",
         CompositeTransform().rotate_about_axis({0, 0, 1}, {1, 0, 1}, 30));
  expect("rotate_in_seven_steps = { from = [0, 1, 0], to = [1, 2, 3], degrees = 30 }",
         rotation_in_seven_steps({0, 1, 0}, {1, 2, 3}, 30));
  expect("shear = { xy = 0.5 }", CompositeTransform().shear(0.5, 0, 0, 0, 0, 0));
  EXPECT_EQ(at(cube_with_step("rotate_z_degrees = [[0, 0], [10, 60]]\nof = \"axes\""), 5),
            CompositeTransform().rotate_z_degrees(-30).matrix());
}

TEST(ShotMotion, RotationTracksAboutTheAxesFollowEachOther) {
  const Scene scene = ShotFolder().load(cube_with(R"([[object.transform]]
translate = [1, 0, 0]
[[object.track]]
target = "rotation_z_degrees"
keys = [[0, 0], [10, 90]]
[[object.track]]
target = "scale"
keys = [[0, 1], [10, 3]]
[[object.track]]
target = "translation"
keys = [[0, [0, 0, 0]], [10, [0, 0, 8]]]
[[object.track]]
target = "rotation_x_degrees"
keys = [[0, 0], [10, 180]]
)"));
  EXPECT_EQ(at(scene, 5), CompositeTransform()
                              .translate({1, 0, 0})
                              .scale({2, 2, 2})
                              .rotate_x_degrees(90)
                              .rotate_z_degrees(45)
                              .translate({0, 0, 4})
                              .matrix());
}

TEST(ShotMotion, OneScaleServesAllAxes) {
  const Scene scene =
      ShotFolder().load(cube_with("[[object.track]]\ntarget = \"scale\"\nkeys = [[0, 1], [10, [3, 5, 7]]]"));
  EXPECT_EQ(at(scene, 5), CompositeTransform().scale({2, 3, 4}).matrix());
}

TEST(ShotMotion, WhatIsWrongIsRefusedWithItsPlace) {
  const ShotFolder folder;
  const auto refusal = [&](const std::string& step) { return folder.refusal(cube_with_step(step)); };
  EXPECT_EQ(refusal("of = \"axes\""), "shot.toml:3:1: a transform step has exactly one key; this one has 0");
  EXPECT_EQ(refusal("scale = 2\nof = \"axis\""), "shot.toml:5:6: unknown of \"axis\"; did you mean \"axes\"?");
  EXPECT_EQ(refusal("scale = [1, 0, 1]\nof = \"axes\""),
            "shot.toml:4:9: step 1, scale by (1, 0, 1), has no inverse; leave it out or use no factor of 0");
  EXPECT_EQ(refusal("matrix = { keys = [[0, 1]] }"),
            "shot.toml:4:10: a matrix has no keys; give them to the steps that it is made of");
  EXPECT_EQ(refusal("rotate_x_degrees = [[0, 0], [0, 90]]"),
            "shot.toml:4:29: frame 0 does not come after frame 0; keys must be in order, one a frame");
  EXPECT_EQ(
      refusal("rotate_x_degrees = { keys = [[0, 0]], target = \"x\" }"),
      "shot.toml:4:39: unknown key \"target\" in rotate_x_degrees; known: interpolation, frequency, damping_ratio, "
      "follows, keys");
  EXPECT_EQ(refusal("rotate_about_axis = { from = [0, 0, 0], to = [0, 0, 0], degrees = [[0, 0]] }"),
            "shot.toml:4:21: rotate_about_axis: both points are (0, 0, 0); an axis needs two different points");
  EXPECT_EQ(folder.refusal(cube_with("[[object.track]]\ntarget = \"rotation\"\nkeys = [[0, [0, 0, 0, 1]]]\n"
                                     "[[object.track]]\ntarget = \"rotation_x_degrees\"\nkeys = [[0, 1]]")),
            "shot.toml:7:10: the object is turned by rotation and by an angle about an axis; keep one of the two");
}

// Where keys bring an axis to nothing, that frame says so.
TEST(ShotMotion, StepThatDegeneratesIsAnErrorOfItsFrame) {
  const Scene scene = ShotFolder().load(
      "[camera]\neye = [0, 0, 5]\n" +
      cube_with_step(
          "rotate_about_axis = { from = [0, 0, 0], to = [[0, [1, 0, 0]], [10, [-1, 0, 0]]], degrees = 40 }"));
  EXPECT_NO_THROW(evaluate(scene.timeline, 4));
  try {
    evaluate(scene.timeline, 5);
    FAIL() << "an axis without length was accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::bad_input);
    EXPECT_NE(error.message().find("frame 5: the transform of \"cube\": rotate_about_axis: both points"),
              std::string::npos)
        << error.message();
  }
}

}  // namespace
}  // namespace morphcl
