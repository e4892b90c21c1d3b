// What a [camera] table says, as a projection and a place. Where points are drawn is tested with the pictures of
// docs/projections.md.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/scene/shot_folder.hpp"

namespace morphcl {
namespace {

Camera camera(const std::string& keys) {
  return test::ShotFolder().load("[camera]\n" + keys + "\n" + std::string(test::cube_object)).timeline.camera;
}

template <typename Form>
Form projection(const std::string& keys) {
  return std::get<Form>(camera(keys).projection);
}

TEST(ShotCamera, HorizontalFieldOfView) {
  const auto p = projection<HorizontalPerspective>("fovx_degrees = 70\nnear = 0.5\nfar = inf");
  EXPECT_EQ(p.fovx_degrees, 70);
  EXPECT_EQ(p.near, 0.5);
  EXPECT_EQ(p.far, INFINITY);
}

TEST(ShotCamera, HorizontalFieldOfViewMoves) {
  const Scene scene = test::ShotFolder().load(
      "[camera]\nfovx_degrees = 70\n[[camera.track]]\ntarget = \"fovx_degrees\"\nkeys = [[0, 40], [10, 60]]\n" +
      std::string(test::cube_object));
  EXPECT_EQ(scene.frames.front().last, 10);
  EXPECT_EQ(std::get<HorizontalPerspective>(evaluate(scene.timeline, 5).camera.projection).fovx_degrees, 50);
}

TEST(ShotCamera, CentralProjectionHasItsBoardInTheTarget) {
  const auto p = projection<CentralProjection>("projection = \"central\"\neye = [0, 0, 200]\nright = 300");
  EXPECT_EQ(p.board, 200);
  EXPECT_EQ(p.left, -2);
  EXPECT_EQ(p.right, 300);
  EXPECT_EQ(p.fit, Fit::widen);
}

TEST(ShotCamera, WindowsAreWidenedUnlessToldOtherwise) {
  for (const char* kind : {"orthographic", "isometric"})
    EXPECT_EQ(projection<Orthographic>("left = -3\nprojection = \"" + std::string(kind) + "\"").fit, Fit::widen);
  EXPECT_EQ(projection<Frustum>("left = -3\nprojection = \"frustum\"").fit, Fit::widen);
  EXPECT_EQ(projection<Frustum>("left = -3\nprojection = \"frustum\"\nfit = \"stretch\"").fit, Fit::stretch);
  EXPECT_EQ(projection<Orthographic>("projection = \"isometric\"\nfit = \"crop\"").fit, Fit::crop);
}

TEST(ShotCamera, ObliqueProjections) {
  const double diagonal = std::sqrt(0.5);
  const auto cavalier = projection<Oblique>("projection = \"cavalier\"");
  EXPECT_DOUBLE_EQ(cavalier.shear.x, diagonal);
  EXPECT_EQ(cavalier.shear.x, cavalier.shear.y);
  EXPECT_EQ(cavalier.plane, 5);
  EXPECT_DOUBLE_EQ(projection<Oblique>("projection = \"cabinet\"").shear.x, 0.5 * diagonal);
  const auto left = projection<Oblique>("projection = \"cabinet\"\nview = \"top\"\ndirection_degrees = 180");
  EXPECT_EQ(left.shear.x, -0.5);
  EXPECT_EQ(left.shear.y, 0);
  EXPECT_EQ(left.plane, 10);
  EXPECT_EQ(projection<Oblique>("projection = \"oblique\"\nfactor = 2\ndirection_degrees = 90").shear.y, 2);
  EXPECT_DOUBLE_EQ(projection<Oblique>("projection = \"oblique\"\nbeta_degrees = 30").shear.x,
                   std::sqrt(3.0) * diagonal);
}

TEST(ShotCamera, ViewsPlaceTheCameraBeforeTheTarget) {
  const Camera top = camera("projection = \"orthographic\"\nview = \"top\"\ntarget = [1, 2, 3]\ndistance = 4");
  EXPECT_EQ(top.eye, glm::dvec3(1, 6, 3));
  EXPECT_EQ(top.target, glm::dvec3(1, 2, 3));
  EXPECT_EQ(top.up, glm::dvec3(0, 0, -1));
  EXPECT_EQ(camera("view = \"left\"").eye, glm::dvec3(-10, 0, 0));
}

TEST(ShotCamera, CornersOfAnIsometricView) {
  const double part = 10 / std::sqrt(3.0);
  const Camera usual = camera("projection = \"isometric\""),
               below = camera("projection = \"isometric\"\ncorner = [-1, -1, 1]");
  for (int i = 0; i < 3; ++i) {
    EXPECT_DOUBLE_EQ(usual.eye[i], part);
    EXPECT_DOUBLE_EQ(below.eye[i], i == 2 ? part : -part);
  }
  EXPECT_GT(below.up.y, 0);
  EXPECT_LT(below.up.x, 0);
}

// Two ways to say how a dimetric view is seen: equal x and z, and y foreshortened to cos 20 degrees.
TEST(ShotCamera, DimetricByElevation) {
  const Camera c = camera("projection = \"dimetric\"\nelevation_degrees = 20");
  EXPECT_EQ(c.eye.x, c.eye.z);
  EXPECT_DOUBLE_EQ(c.eye.y, 10 * std::sin(20 * M_PI / 180));
}

}  // namespace
}  // namespace morphcl
