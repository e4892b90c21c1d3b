#include "demos/viewer/view_camera.hpp"

#include <gtest/gtest.h>

#include "morphcl/error.hpp"
#include "morphcl/transform.hpp"

namespace morphcl::viewer {
namespace {

constexpr double kSquare = 1.0;
// Two rotation matrices of entries within 2^-51, their product and its product with a vector: below 32 roundings of
// 2^-53, of the vector's length.
constexpr double kRotationBound = 32 * 0x1p-53;

const Perspective kPerspective{.fovy_degrees = 45, .near = 0.1, .far = 100};

Timeline timeline_with(const Projection& projection, const glm::dvec3& eye) {
  Timeline timeline;
  timeline.camera.projection = projection;
  timeline.camera.eye = eye;
  return timeline;
}

DemoSettings teapot_settings() {
  DemoSettings settings;
  settings.orthographic = Orthographic{-5, 5, -5, 5, -10, 10};
  settings.frustum = Frustum{-2, 2, -2, 2, 3, 10};
  return settings;
}

void expect_near(const glm::dvec3& actual, const glm::dvec3& expected, double bound, const char* what) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(actual[i], expected[i], bound) << what << " component " << i;
}

TEST(ViewCamera, AViewThatChangesNothingIsTheShotsOwn) {
  const Timeline timeline = timeline_with(kPerspective, {3, 2, 5});
  EXPECT_EQ(shot_projection(timeline, 0), ProjectionKind::frustum);
  EXPECT_FALSE(view_camera(timeline, 0, View{}, {}, kSquare).has_value());
}

TEST(ViewCamera, EyeMovesUpByFortiethsOfTheDistance) {
  const Timeline timeline = timeline_with(Orthographic{-5, 5, -5, 5, -10, 10}, {0, 0, 8});
  for (const int steps : {1, 3, -4, 40}) {
    View view;
    view.projection = ProjectionKind::orthographic;
    view.eye_steps = steps;
    const Camera camera = view_camera(timeline, 0, view, teapot_settings(), kSquare).value();
    EXPECT_EQ(camera.eye, glm::dvec3(0, steps / 5.0, 8)) << steps << " steps of 0.2";
    EXPECT_EQ(camera.target, glm::dvec3(0));
  }
}

TEST(ViewCamera, KeysChooseTheDemosOwnProjections) {
  const Timeline timeline = timeline_with(kPerspective, {0, 0, 8});
  View view;
  view.projection = ProjectionKind::orthographic;
  const auto planes = std::get<Orthographic>(view_camera(timeline, 0, view, teapot_settings(), 2.0)->projection);
  EXPECT_EQ(planes.right, 10);
  EXPECT_EQ(planes.top, 5);
  EXPECT_EQ(planes.near, -10);
  view.projection = ProjectionKind::frustum;
  const auto frustum = std::get<Frustum>(view_camera(timeline, 0, view, teapot_settings(), kSquare)->projection);
  EXPECT_EQ(frustum.right, 2);
  EXPECT_EQ(frustum.near, 3);
}

TEST(ViewCamera, OtherProjectionOfAShotMatchesItsOwn) {
  const Timeline timeline = timeline_with(kPerspective, {0, 0, 10});
  View view;
  view.projection = ProjectionKind::orthographic;
  const auto planes = std::get<Orthographic>(view_camera(timeline, 0, view, {}, 2.0)->projection);
  const double half_height = 10 * 0.41421356237309503;  // tan 22.5 degrees = sqrt 2 - 1
  EXPECT_NEAR(planes.top, half_height, half_height * 0x1p-50);
  EXPECT_EQ(planes.right, 2 * planes.top);
}

TEST(ViewCamera, MovingTheEyeKeepsTheShotsProjection) {
  View view;
  view.eye_steps = 1;
  const auto camera = view_camera(timeline_with(kPerspective, {3, 2, 5}), 0, view, {}, kSquare);
  EXPECT_EQ(std::get<Perspective>(camera->projection).fovy_degrees, 45);
}

TEST(ViewCamera, QuarterOrbitToTheRightIsExact) {
  View view;
  view.orbit_right = kOrbitSteps / 4;
  const auto camera = view_camera(timeline_with(kPerspective, {0, 0, 8}), 0, view, {}, kSquare);
  EXPECT_EQ(camera->eye, glm::dvec3(8, 0, 0));
  EXPECT_EQ(camera->up, glm::dvec3(0, 1, 0));
}

TEST(ViewCamera, QuarterOrbitUpwardsTakesTheUpVectorAlong) {
  View view;
  view.orbit_up = kOrbitSteps / 4;
  const auto camera = view_camera(timeline_with(kPerspective, {0, 0, 8}), 0, view, {}, kSquare);
  EXPECT_EQ(camera->eye, glm::dvec3(0, 8, 0));
  EXPECT_EQ(camera->up, glm::dvec3(0, 0, -1));
}

TEST(ViewCamera, EveryOrbitKeepsTheDistanceAndIsACamera) {
  const glm::dvec3 eye(3, 2.4, 5.1);
  Timeline timeline = timeline_with(kPerspective, eye);
  timeline.camera.target = {0.5, -0.25, 1};
  const double distance = glm::distance(eye, timeline.camera.target);
  for (int right = 0; right < kOrbitSteps; right += 50) {
    for (int up = 0; up < kOrbitSteps; up += 10) {
      if (right == 0 && up == 0) continue;
      View view;
      view.orbit_right = right;
      view.orbit_up = up;
      const Camera camera = view_camera(timeline, 0, view, {}, kSquare).value();
      EXPECT_NEAR(glm::distance(camera.eye, camera.target), distance, kRotationBound * distance) << right << ' ' << up;
      Timeline moved = timeline;
      moved.camera = camera;
      EXPECT_FALSE(evaluate(moved, 0).camera.up_replaced) << right << ' ' << up;
    }
  }
}

// The deck turns what it shows by `degrees` about (1, 0, 1): the eye sees the points as they would be after it.
TEST(ViewCamera, ASceneThatTurnsLooksTurned) {
  DemoSettings settings;
  settings.turning = Turning{.axis = {1, 0, 1}, .degrees_a_tick = 0.5};
  const Timeline timeline = timeline_with(Orthographic{-1, 1, -1, 1, -10, 10}, {0, 0, 1});
  const glm::dvec4 point(0.5, 0.25, -0.125, 1);
  for (const int ticks : {1, 120, 360, 719}) {
    View view;
    view.projection = ProjectionKind::orthographic;
    view.turn = ticks;
    Timeline turned = timeline;
    turned.camera = view_camera(timeline, 0, view, settings, kSquare).value();
    CompositeTransform turn;
    turn.rotate_about_axis(glm::dvec3(0), {1, 0, 1}, 0.5 * ticks);
    expect_near(evaluate(turned, 0).camera.world_to_eye * point,
                evaluate(timeline, 0).camera.world_to_eye * (turn.matrix() * point), kRotationBound, "point");
  }
}

TEST(ViewCamera, TheWheelBringsTheEyeNearerOrMakesTheWindowSmaller) {
  View view;
  view.zoom = static_cast<int>(kZoomSteps);  // twice as large
  const Camera nearer = view_camera(timeline_with(kPerspective, {0, 0, 8}), 0, view, {}, kSquare).value();
  EXPECT_EQ(nearer.eye, glm::dvec3(0, 0, 4));
  EXPECT_EQ(std::get<Perspective>(nearer.projection).fovy_degrees, 45);

  view.projection = ProjectionKind::orthographic;
  const Timeline parallel = timeline_with(Orthographic{-4, 4, -4, 4, -10, 10}, {0, 0, 8});
  const Camera smaller = view_camera(parallel, 0, view, {}, 2.0).value();
  EXPECT_EQ(smaller.eye, glm::dvec3(0, 0, 8));
  const auto planes = std::get<Orthographic>(smaller.projection);
  EXPECT_EQ(planes.top, 2);
  EXPECT_EQ(planes.right, 4) << "as the image showed it: widened to its aspect";

  const Timeline oblique = timeline_with(Oblique{.shear = {0.5, 0.25}, .plane = 3}, {0, 0, 8});
  const auto slanted = std::get<Oblique>(view_camera(oblique, 0, view, {}, kSquare)->projection);
  EXPECT_EQ(slanted.top, 0.5);
  EXPECT_EQ(slanted.shear.x, 0.5);
}

TEST(ViewCamera, UpVectorsOfAnyLengthMoveTheSame) {
  for (const double length : {1e-200, 1.0, 1e200}) {
    Timeline timeline = timeline_with(kPerspective, {0, 0, 8});
    timeline.camera.up = {0, length, 0};
    View view;
    view.eye_steps = 5;
    EXPECT_EQ(view_camera(timeline, 0, view, {}, kSquare)->eye, glm::dvec3(0, 1, 8)) << length;
  }
}

TEST(ViewCamera, UpVectorAlongTheViewIsReplacedByThePicturesOwn) {
  Timeline timeline = timeline_with(kPerspective, {0, 0, 8});
  timeline.camera.up = {0, 0, 1};
  for (const int steps : {-40, 40}) {  // along the given up vector, 40 steps would end in the target
    View view;
    view.eye_steps = steps;
    const Camera camera = view_camera(timeline, 0, view, {}, kSquare).value();
    EXPECT_EQ(camera.eye.z, 8);
    EXPECT_GT(glm::distance(camera.eye, camera.target), 8);
  }
}

TEST(ViewCamera, TracksAreTakenAtTheFrame) {
  Timeline timeline = timeline_with(kPerspective, {9, 9, 9});
  timeline.camera.eye_track = Track({Interpolation::linear,
                                     3,
                                     false,
                                     timeline.time.ticks_per_second(),
                                     {0, timeline.time.frame_ticks(10)},
                                     {0, 0, 4, 0, 0, 8}});
  timeline.camera.fovy_track = Track({Interpolation::linear,
                                      1,
                                      false,
                                      timeline.time.ticks_per_second(),
                                      {0, timeline.time.frame_ticks(10)},
                                      {40, 60}});
  View view;
  view.eye_steps = 10;
  const Camera camera = view_camera(timeline, 5, view, {}, kSquare).value();
  EXPECT_EQ(camera.eye, glm::dvec3(0, 1.5, 6));
  EXPECT_EQ(std::get<Perspective>(camera.projection).fovy_degrees, 50);
  EXPECT_TRUE(camera.eye_track.empty());
  EXPECT_TRUE(camera.fovy_track.empty());
}

TEST(ViewCamera, ACameraInANodeOrbitsAboutItsViewAxis) {
  Timeline timeline = timeline_with(kPerspective, {0, 0, 0});
  Node node;
  node.translation = {1, 2, 10};
  timeline.nodes.push_back(node);
  timeline.camera.node = 0;
  EXPECT_FALSE(view_camera(timeline, 0, View{}, {}, kSquare).has_value());
  View view;
  view.orbit_right = kOrbitSteps / 2;
  const Camera camera = view_camera(timeline, 0, view, {}, kSquare).value();
  EXPECT_EQ(camera.node, -1);
  expect_near(camera.target, {1, 2, 0}, kRotationBound * 10, "target");
  expect_near(camera.eye, {1, 2, -10}, kRotationBound * 10, "eye");
}

TEST(ViewCamera, AShotWithoutACameraIsRefused) {
  const Timeline timeline = timeline_with(kPerspective, {0, 0, 0});  // eye equals target
  EXPECT_THROW(view_camera(timeline, 0, View{}, {}, kSquare), Error);
}

}  // namespace
}  // namespace morphcl::viewer
