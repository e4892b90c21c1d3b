// Tracks of an object's colour.
#include <gtest/gtest.h>

#include <string>

#include "host/scene/model/base_color.hpp"
#include "tests/scene/shot_folder.hpp"

namespace morphcl {
namespace {

using test::ShotFolder;

std::string cube_with_color(std::string_view track) {
  return "[[object]]\nmesh = \"cube\"\ncolor = [1, 0, 0, 0.5]\n[[object.track]]\ntarget = \"color\"\n" +
         std::string(track);
}

glm::dvec4 color_at(const Scene& scene, std::int64_t frame) {
  return base_color_at(scene.objects[0].material, scene.timeline.time.frame_ticks(frame));
}

TEST(ShotColorTrack, MovesTheBaseColor) {
  const Scene scene = ShotFolder().load(cube_with_color("keys = [[0, [1, 0, 0]], [10, [0, 0, 4]]]"));
  EXPECT_EQ(color_at(scene, 0), glm::dvec4(1, 0, 0, 0.5));
  EXPECT_EQ(color_at(scene, 5), glm::dvec4(0.5, 0, 2, 0.5));  // alpha stays that of color
  EXPECT_EQ(color_at(scene, 10), glm::dvec4(0, 0, 4, 0.5));
  EXPECT_EQ(scene.frames[0].last, 10);
}

TEST(ShotColorTrack, MovesAlphaWhereKeysHaveIt) {
  const Scene scene = ShotFolder().load(cube_with_color("keys = [[0, [1, 0, 0, 1]], [10, [0, 0, 4, 0]]]"));
  EXPECT_EQ(color_at(scene, 5), glm::dvec4(0.5, 0, 2, 0.5));
  EXPECT_EQ(color_at(scene, 10), glm::dvec4(0, 0, 4, 0));
}

TEST(ShotColorTrack, BringsBackWhatOvershoots) {
  const Scene scene = ShotFolder().load(
      cube_with_color("interpolation = \"cubic\"\nkeys = [[0, [0, 0, 0, 1], [0, 0, 0, 0], [-1, 0, 0, 1]],"
                      " [10, [0, 0, 0, 1], [-1, 0, 0, -1], [0, 0, 0, 0]]]"));
  EXPECT_EQ(color_at(scene, 2), glm::dvec4(0, 0, 0, 1));
}

TEST(ShotColorTrack, ObjectThatFadesInIsKept) {
  const Scene scene = ShotFolder().load(
      "[[object]]\nmesh = \"cube\"\ncolor = [1, 1, 1, 0]\n[[object.track]]\ntarget = \"color\"\n"
      "keys = [[0, [1, 1, 1, 0]], [10, [1, 1, 1, 1]]]");
  EXPECT_EQ(scene.objects.size(), 1u);
}

TEST(ShotColorTrack, WhatIsWrongIsRefusedWithItsPlace) {
  const ShotFolder folder;
  const auto refusal = [&](const char* track) { return folder.refusal(cube_with_color(track)); };
  EXPECT_EQ(refusal("keys = [[0, [1, 0, 0, 1]], [10, [0, 0, 4]]]"),
            "shot.toml:6:33: where one key has alpha all have it: [red, green, blue, alpha]");
  EXPECT_EQ(refusal("keys = [[0, [1, 0, 0, 2]]]"), "shot.toml:6:23: color holds 2; 0 to 1 is needed");
  EXPECT_EQ(refusal("keys = [[0, [1, -1, 0, 1]]]"), "shot.toml:6:17: color holds -1; 0 or more is needed");
  EXPECT_EQ(refusal("keys = [[0, 1]]"), "shot.toml:6:13: keys must be three numbers: [red, green, blue]");
  EXPECT_EQ(folder.refusal("[[object]]\nmesh = \"none\"\nname = \"g\"\n[[object.track]]\ntarget = \"color\"\n"
                           "keys = [[0, [1, 1, 1]]]"),
            "shot.toml:5:10: a group, mesh = \"none\", draws nothing; it has no color");
}

}  // namespace
}  // namespace morphcl
