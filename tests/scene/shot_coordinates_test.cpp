// Cylindrical, polar and spherical coordinates wherever a shot gives a point.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tests/scene/shot_folder.hpp"

namespace morphcl {
namespace {

using test::ShotFolder;

glm::dvec3 moved_by(const std::string& point) {
  const Scene scene = ShotFolder().load("[[object]]\nmesh = \"cube\"\n[[object.transform]]\ntranslate = " + point);
  return glm::dvec3(scene.timeline.nodes[0].static_transform[3]);
}

TEST(ShotCoordinates, AreExactAtMultiplesOfNinetyDegrees) {
  EXPECT_EQ(moved_by("{ cylindrical = [2, 0, 5] }"), glm::dvec3(0, 5, 2));
  EXPECT_EQ(moved_by("{ cylindrical = [2, 90, 5] }"), glm::dvec3(2, 5, 0));
  EXPECT_EQ(moved_by("{ cylindrical = [2, 180, 5] }"), glm::dvec3(0, 5, -2));
  EXPECT_EQ(moved_by("{ cylindrical = [2, 270, 5] }"), glm::dvec3(-2, 5, 0));
  EXPECT_EQ(moved_by("{ cylindrical = [2, -3600000090, 5] }"), glm::dvec3(-2, 5, 0));
  EXPECT_EQ(moved_by("{ polar = [3, 0] }"), glm::dvec3(3, 0, 0));
  EXPECT_EQ(moved_by("{ polar = [3, 90] }"), glm::dvec3(0, 3, 0));
  EXPECT_EQ(moved_by("{ polar = [3, 180] }"), glm::dvec3(-3, 0, 0));
  EXPECT_EQ(moved_by("{ spherical = [4, 0, 0] }"), glm::dvec3(0, 4, 0));
  EXPECT_EQ(moved_by("{ spherical = [4, 90, 90] }"), glm::dvec3(4, 0, 0));
  EXPECT_EQ(moved_by("{ spherical = [4, 0, 90] }"), glm::dvec3(0, 0, 4));
  EXPECT_EQ(moved_by("{ spherical = [4, 12345, 180] }"), glm::dvec3(0, -4, 0));
  EXPECT_EQ(moved_by("{ spherical = [1, 30, 90] }").x, 0.5);
}

// The angle is one double, its sine correctly rounded or the double beside it: 1u64, and 1u64 for each product.
TEST(ShotCoordinates, AreCloseToTheExactPoint) {
  constexpr long double degree = 3.14159265358979323846264338327950288L / 180;
  for (int azimuth = -370; azimuth <= 370; azimuth += 37)
    for (int polar = 0; polar <= 180; polar += 29) {
      const glm::dvec3 point =
          moved_by("{ spherical = [7, " + std::to_string(azimuth) + ", " + std::to_string(polar) + "] }");
      const long double a = azimuth * degree, p = polar * degree;
      const long double exact[3] = {7 * std::sin(p) * std::sin(a), 7 * std::cos(p), 7 * std::sin(p) * std::cos(a)};
      // 4u64 of the radius, and what the judge itself is off by.
      for (int c = 0; c < 3; ++c) EXPECT_NEAR(point[c], static_cast<double>(exact[c]), 7 * 0x1p-50) << azimuth << polar;
    }
}

TEST(ShotCoordinates, StandWhereverAPointIsGiven) {
  const Scene scene = ShotFolder().load(R"(
[camera]
eye = { spherical = [5, 90, 90] }
target = { polar = [1, 90] }
up = { cylindrical = [0, 0, 2] }
[[light]]
position = { cylindrical = [2, 90, 3] }
[[light]]
direction = { spherical = [1, 0, 0] }
[[light.track]]
target = "direction"
keys = [[0, { spherical = [1, 0, 0] }], [10, { spherical = [1, 90, 90] }]]
[[object]]
mesh = "cube"
[[object.transform]]
rotate_about_axis = { from = { polar = [1, 0] }, to = { polar = [1, 90] }, degrees = 180 }
[[object.track]]
target = "translation"
keys = [[0, { cylindrical = [1, 0, 0] }], [10, [0, 0, 3]]]
[[object.track]]
target = "rotation"
keys = [[0, { axis = { polar = [1, 90] }, degrees = 90 }]]
)");
  const FrameState state = evaluate(scene.timeline, 5);
  const Camera& camera = scene.timeline.camera;
  EXPECT_EQ(camera.eye, glm::dvec3(5, 0, 0));
  EXPECT_EQ(camera.target, glm::dvec3(0, 1, 0));
  EXPECT_EQ(camera.up, glm::dvec3(0, 2, 0));
  EXPECT_EQ(state.lights[0].vector, glm::dvec3(2, 3, 0));
  EXPECT_EQ(state.lights[1].vector, glm::normalize(glm::dvec3(0.5, 0.5, 0)));  // straight from key to key
  EXPECT_EQ(glm::dvec3(state.node_to_world[0] * glm::dvec4(1, 0, 0, 1)), glm::dvec3(0, 0, 1));
}

TEST(ShotCoordinates, WhatIsWrongIsRefusedWithItsPlace) {
  const ShotFolder folder;
  const auto refusal = [&](const std::string& point) {
    return folder.refusal("[[object]]\nmesh = \"cube\"\n[[object.transform]]\ntranslate = " + point);
  };
  EXPECT_EQ(refusal("{ spherical = [1, 2] }"),
            "shot.toml:4:27: spherical must be three numbers: [radius, azimuth, polar angle], in degrees");
  EXPECT_EQ(refusal("{ polar = [1, 2, 3] }"), "shot.toml:4:23: polar must be two numbers: [radius, angle in degrees]");
  EXPECT_EQ(refusal("{ cylindrical = 3 }"),
            "shot.toml:4:29: cylindrical must be three numbers: [radius, azimuth in degrees, height]");
  EXPECT_EQ(refusal("{ sperical = [1, 2, 3] }"),
            "shot.toml:4:15: unknown key \"sperical\" in translate; did you mean \"spherical\"?");
  EXPECT_EQ(refusal("{ polar = [1, 2], spherical = [1, 2, 3] }"),
            "shot.toml:4:13: translate has one of cylindrical, polar and spherical; this one has 2");
  EXPECT_EQ(refusal("{ polar = [1, inf] }"), "shot.toml:4:27: polar is inf; a finite number is needed");
  EXPECT_EQ(folder.refusal("[[object]]\nmesh = \"cube\"\n[[object.transform]]\nscale = { polar = [1, 2] }"),
            "shot.toml:4:9: scale must be three numbers: [x, y, z]");
}

}  // namespace
}  // namespace morphcl
