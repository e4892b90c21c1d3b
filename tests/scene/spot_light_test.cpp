// Spot lights in shots.
#include <gtest/gtest.h>

#include <string>

#include "tests/scene/shot_folder.hpp"

namespace morphcl {
namespace {

using test::ShotFolder;

std::string with_light(std::string_view light) {
  return "[[light]]\n" + std::string(light) + "\n" + std::string(test::cube_object);
}

TEST(ShotSpotLight, LeadsFromItsPositionThroughItsTarget) {
  const Scene scene = ShotFolder().load(
      with_light("position = [0, 4, 0]\ntarget = [0, 1, 0]\ncone_degrees = [10, 30]\n[[light.track]]\n"
                 "target = \"target\"\nkeys = [[0, [0, 1, 0]], [10, [4, 4, 0]]]"));
  const LightState first = evaluate(scene.timeline, 0).lights[0], last = evaluate(scene.timeline, 10).lights[0];
  ASSERT_TRUE(first.spot && last.spot);
  EXPECT_EQ(first.kind, LightKind::point);
  EXPECT_EQ(first.vector, glm::dvec3(0, 4, 0));
  EXPECT_EQ(first.spot->beam, glm::dvec3(0, -1, 0));
  EXPECT_EQ(last.spot->beam, glm::dvec3(1, 0, 0));
  EXPECT_EQ(first.spot->inner_cone_degrees, 10);
  EXPECT_EQ(first.spot->outer_cone_degrees, 30);
  EXPECT_EQ(scene.frames[0].last, 10);
}

TEST(ShotSpotLight, TurnsWithItsParent) {
  const Scene scene = ShotFolder().load(with_light("position = [0, 4, 0]\ntarget = [0, 1, 0]\nparent = \"lamp\"") +
                                        "name = \"lamp\"\n[[object.transform]]\nrotate_z_degrees = 90\n");
  const LightState light = evaluate(scene.timeline, 0).lights[0];
  EXPECT_EQ(light.vector, glm::dvec3(-4, 0, 0));
  EXPECT_EQ(light.spot->beam, glm::dvec3(1, 0, 0));
}

TEST(ShotSpotLight, WhatIsWrongIsRefusedWithItsPlace) {
  const ShotFolder folder;
  const auto refusal = [&](const char* light) { return folder.refusal(with_light(light)); };
  EXPECT_EQ(refusal("direction = [0, 1, 0]\ntarget = [0, 0, 0]"),
            "shot.toml:3:10: a light with a target, a spot light, has a position, not a direction");
  EXPECT_EQ(refusal("position = [0, 1, 0]\ncone_degrees = [10, 30]"),
            "shot.toml:3:16: cone_degrees belongs to a spot light, which has a position and a target");
  EXPECT_EQ(refusal("position = [0, 1, 0]\ntarget = [0, 1, 0]"),
            "shot.toml:3:10: the spot light stands at its target; a beam needs a direction");
  EXPECT_EQ(refusal("position = [0, 1, 0]\ntarget = [0, 0, 0]\ncone_degrees = [30, 10]"),
            "shot.toml:4:16: cone_degrees is [30, 10]; 0 or more, and from 0.01 more up to 90 degrees, is needed");
  EXPECT_EQ(refusal("position = [0, 1, 0]\ntarget = [0, 0, 0]\ncone_degrees = 30"),
            "shot.toml:4:16: cone_degrees must be two numbers: [inner, outer], degrees from the beam's axis");
  EXPECT_EQ(refusal("position = [0, 1, 0]\n[[light.track]]\ntarget = \"target\"\nkeys = [[0, [0, 0, 0]]]"),
            "shot.toml:4:10: a light has no value \"target\" to move; known: position, color");
}

}  // namespace
}  // namespace morphcl
