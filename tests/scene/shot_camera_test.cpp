// What a [camera] table says, as a projection and a place. Where points are drawn is tested with the pictures of
// docs/projections.md.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tests/scene/outline.hpp"
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
  EXPECT_EQ(projection<Orthographic>("projection = \"isometric\"\nfit = \"adjust_x\"").fit, Fit::adjust_x);
  EXPECT_EQ(projection<Orthographic>("projection = \"isometric\"\nfit = \"adjust_y\"").fit, Fit::adjust_y);
}

TEST(ShotCamera, ObliqueProjections) {
  const double diagonal = std::sqrt(0.5);
  const auto cavalier = projection<Oblique>("projection = \"cavalier\"\neye = [0, 0, 5]");
  EXPECT_DOUBLE_EQ(cavalier.shear.x, diagonal);
  EXPECT_EQ(cavalier.shear.x, cavalier.shear.y);
  EXPECT_EQ(cavalier.plane, 5);
  EXPECT_DOUBLE_EQ(projection<Oblique>("projection = \"cabinet\"").shear.x, 0.5 * diagonal);
  const auto left =
      projection<Oblique>("projection = \"cabinet\"\nview = \"top\"\ndirection_degrees = 180\ndistance = 10");
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
  EXPECT_EQ(camera("view = \"left\"\ntarget = [0, 0, 0]").eye, glm::dvec3(-10, 0, 0));
}

TEST(ShotCamera, CornersOfAnIsometricView) {
  const double part = 10 / std::sqrt(3.0);
  const Camera usual = camera("projection = \"isometric\"\ndistance = 10"),
               below = camera("projection = \"isometric\"\ndistance = 10\ncorner = [-1, -1, 1]");
  for (int i = 0; i < 3; ++i) {
    EXPECT_DOUBLE_EQ(usual.eye[i], part);
    EXPECT_DOUBLE_EQ(below.eye[i], i == 2 ? part : -part);
  }
  EXPECT_GT(below.up.y, 0);
  EXPECT_LT(below.up.x, 0);
}

// Two ways to say how a dimetric view is seen: equal x and z, and y foreshortened to cos 20 degrees.
TEST(ShotCamera, DimetricByElevation) {
  const Camera c = camera("projection = \"dimetric\"\nelevation_degrees = 20\ndistance = 10");
  EXPECT_EQ(c.eye.x, c.eye.z);
  EXPECT_DOUBLE_EQ(c.eye.y, 10 * std::sin(20 * M_PI / 180));
}

// The film's half height over the focal length is the tangent of half the angle; 1 at 45 degrees.
TEST(ShotCamera, LensIsGivenByItsFocalLength) {
  EXPECT_EQ(projection<Perspective>("focal_length = 12").fovy_degrees, 90);
  EXPECT_EQ(projection<Perspective>("focal_length = 2\nfilm = [9, 4]").fovy_degrees, 90);
  EXPECT_NEAR(projection<Perspective>("focal_length = 50").fovy_degrees, 26.991466561591626, 1e-14);
  EXPECT_EQ(projection<Perspective>("focal_length = 50\nnear = 2").near, 2);
}

TEST(ShotCamera, ProjectorsAreGivenByTheirDirection) {
  const auto oblique = [](const char* keys) {
    return projection<Oblique>("projection = \"oblique\"\n" + std::string(keys)).shear;
  };
  EXPECT_EQ(oblique("projectors = [1, 2, 4]").x, 0.25);
  EXPECT_EQ(oblique("projectors = [1, 2, 4]").y, 0.5);
  EXPECT_EQ(oblique("projectors = [-1, -1, -1]").x, 1);  // cavalier, and the direction's sign does not matter
}

// ---- fitted: where the table does not say where the camera stands ---------------------------------------------------

constexpr std::string_view teapot_object = "[[object]]\nmesh = \"teapot\"\n";

Scene fitted(const std::string& keys, const LoadOptions& options = {}) {
  return test::ShotFolder().load("[camera]\n" + keys + "\n" + std::string(teapot_object), options);
}

TEST(FittedShotCamera, EveryProjection) {
  const std::string trimetric =
      "projection = \"trimetric\"\nazimuth_degrees = 30\nelevation_degrees = 20\ncorner = [-1, 1, -1]";
  for (const std::string& keys : std::vector<std::string>{
           "", "fovy_degrees = 20", "fovy_degrees = 130", "fovx_degrees = 70", "up = [1, 1, 0]", "near = 0.5",
           "far = inf", "projection = \"frustum\"", "projection = \"frustum\"\nnear = 0.5", "projection = \"central\"",
           "projection = \"orthographic\"", "projection = \"cavalier\"", "projection = \"cabinet\"\nview = \"left\"",
           "projection = \"oblique\"\nfactor = 2\ndirection_degrees = 200", "projection = \"isometric\"",
           "projection = \"dimetric\"", trimetric, "direction = [-3, -1, 2]"}) {
    SCOPED_TRACE(keys);
    test::expect_fills(fitted(keys));
  }
}

TEST(FittedShotCamera, EveryView) {
  for (const char* view : {"three_quarter", "front", "back", "left", "right", "top", "bottom"})
    for (const char* projection : {"perspective", "orthographic"}) {
      SCOPED_TRACE(std::string(view) + " " + projection);
      const Scene in_shot = fitted("projection = \"" + std::string(projection) + "\"\nview = \"" + view + "\"");
      test::expect_fills(in_shot);
      LoadOptions options;
      options.view = view;
      const Scene by_option = fitted("projection = \"" + std::string(projection) + "\"\nview = \"back\"", options);
      EXPECT_EQ(by_option.timeline.camera.eye, in_shot.timeline.camera.eye);
      EXPECT_EQ(by_option.timeline.camera.up, in_shot.timeline.camera.up);
    }
}

TEST(FittedShotCamera, LooksFromTheSideThatItIsNamedAfter) {
  const Camera left = fitted("view = \"left\"").timeline.camera, top = fitted("view = \"top\"").timeline.camera;
  EXPECT_LT(left.eye.x, -2);
  EXPECT_NEAR(left.eye.z, left.target.z, 1e-12);
  EXPECT_GT(top.eye.y, 2);
  EXPECT_EQ(top.up, glm::dvec3(0, 0, -1));
  EXPECT_EQ(fitted("").timeline.camera.eye, fitted("view = \"three_quarter\"").timeline.camera.eye);
}

TEST(FittedShotCamera, KeepsTheDistancesThatAreGiven) {
  const auto lens = std::get<Perspective>(fitted("near = 0.25").timeline.camera.projection);
  EXPECT_EQ(lens.near, 0.25);
  EXPECT_LT(lens.far, 20);
  const auto behind = std::get<Perspective>(fitted("near = 500").timeline.camera.projection);
  EXPECT_EQ(behind.near, 500);
  EXPECT_GT(behind.far, 500);
  const auto before = std::get<Perspective>(fitted("far = 0.01").timeline.camera.projection);
  EXPECT_EQ(before.far, 0.01);
  EXPECT_LT(before.near, 0.01);
}

TEST(FittedShotCamera, FitsTheFirstFrameOfAFieldOfViewThatMoves) {
  const Scene scene = fitted("[[camera.track]]\ntarget = \"fovy_degrees\"\nkeys = [[0, 20], [10, 60]]");
  Scene first = scene;
  first.frames = {{0, 0, 1}};
  test::expect_fills(first);
}

TEST(FittedShotCamera, IsPlacedByAnEyeATargetADistanceAWindowOrATrack) {
  EXPECT_EQ(fitted("eye = [0, 0, 7]").timeline.camera.eye, glm::dvec3(0, 0, 7));
  EXPECT_EQ(fitted("target = [0, 1, 0]").timeline.camera.eye, glm::dvec3(0, 0, 5));
  EXPECT_EQ(fitted("direction = [3, 0, 0]\ndistance = 2").timeline.camera.eye, glm::dvec3(2, 0, 0));
  EXPECT_EQ(fitted("projection = \"orthographic\"\ntop = 3").timeline.camera.eye, glm::dvec3(0, 0, 5));
  EXPECT_EQ(fitted("[[camera.track]]\ntarget = \"up\"\nkeys = [[0, [0, 1, 0]]]").timeline.camera.eye,
            glm::dvec3(0, 0, 5));
}

TEST(ViewOption, IsRefusedWhereItCannotTurnTheCamera) {
  const test::ShotFolder folder;
  LoadOptions options;
  options.view = "left";
  const auto refusal = [&](const std::string& keys) {
    return folder.refusal("[camera]\n" + keys + "\n" + std::string(teapot_object), options);
  };
  EXPECT_EQ(refusal("eye = [0, 0, 7]"),
            "NOT bad_input: shot.toml:1:1: --view turns a fitted camera; the shot's says itself where it stands, so "
            "leave --view out");
  EXPECT_NE(refusal("projection = \"isometric\"").find("has the direction of its projection"), std::string::npos);
  options.view = "side";
  EXPECT_EQ(refusal(""),
            "NOT bad_input: shot.toml: there is no view \"side\"; views are three_quarter, front, back, left, right, "
            "top, bottom");
}

}  // namespace
}  // namespace morphcl
