// The tracks of a shot, judged by what they say at a frame.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/scene/shot_folder.hpp"

namespace morphcl {
namespace {

using test::ShotFolder;

// fp64 with a handful of operations on numbers up to 10.
const double rounding_bound = 64 * std::ldexp(1.0, -53);

Scene with_track(const std::string& track, const std::string& before = "") {
  return ShotFolder().load(before + "[[object]]\nmesh = \"pyramid_to_cube\"\n[[object.track]]\n" + track);
}

double weight_at(const Scene& scene, std::int64_t frame) {
  return weights_at(scene.objects[0].morph, scene.timeline.time, frame)[0];
}

TEST(ShotTrack, LinearMorphIsExactAtEveryStep) {
  const Scene scene = with_track("target = \"morph.cube\"\nkeys = [[0, 0.0], [100, 1.0]]");
  EXPECT_EQ(frame_numbers(scene.frames).size(), 101u) << "without a range: frame 0 to the last key";
  for (int step = 0; step <= 100; ++step) EXPECT_EQ(weight_at(scene, step), step / 100.0) << "step " << step;
}

TEST(ShotTrack, StepHolds) {
  const Scene scene = with_track("target = \"morph.cube\"\ninterpolation = \"step\"\nkeys = [[0, 0.25], [10, 1]]");
  EXPECT_EQ(weight_at(scene, 9), 0.25);
  EXPECT_EQ(weight_at(scene, 10), 1);
}

// Hermite's cubic between two keys 10 frames apart, tangents in change per frame: h00 a + 10 h10 m + h01 b + 10 h11 n.
double hermite(double u, double a, double m, double b, double n) {
  return (1 + 2 * u) * (1 - u) * (1 - u) * a + 10 * u * (1 - u) * (1 - u) * m + u * u * (3 - 2 * u) * b +
         10 * u * u * (u - 1) * n;
}

TEST(ShotTrack, CubicTangentsAreChangePerFrameWhateverTheRate) {
  for (const char* fps : {"fps = 25\n", "fps = [30000, 1001]\n"}) {
    const Scene scene =
        with_track("target = \"morph.cube\"\ninterpolation = \"cubic\"\nkeys = [[0, 1, 9, 0.1], [10, 2, -0.2, 9]]",
                   std::string("[frames]\n") + fps);
    for (int frame = 0; frame <= 10; ++frame)
      EXPECT_NEAR(weight_at(scene, frame), hermite(frame / 10.0, 1, 0.1, 2, -0.2), 4 * rounding_bound)
          << fps << "frame " << frame;
  }
}

TEST(ShotTrack, CubicWithoutTangentsIsCatmullRoms) {
  const Scene scene =
      with_track("target = \"morph.cube\"\ninterpolation = \"cubic\"\nkeys = [[0, 0], [10, 1], [20, 4], [30, 4]]");
  for (int frame = 0; frame <= 10; ++frame) {
    const double u = frame / 10.0;
    EXPECT_NEAR(weight_at(scene, frame), hermite(u, 0, 0.1, 1, 0.2), 4 * rounding_bound) << "frame " << frame;
    EXPECT_NEAR(weight_at(scene, 10 + frame), hermite(u, 1, 0.2, 4, 0.15), 4 * rounding_bound)
        << "frame " << 10 + frame;
    EXPECT_NEAR(weight_at(scene, 20 + frame), hermite(u, 4, 0.15, 4, 0), 4 * rounding_bound) << "frame " << 20 + frame;
  }
}

// Two keys a thousandth of a frame apart: their steep slope does not throw the curve out of their neighbourhood.
TEST(ShotTrack, CubicThroughNearlyCoincidentKeysStaysBetweenThem) {
  const Scene scene =
      with_track("target = \"morph.cube\"\ninterpolation = \"cubic\"\nkeys = [[0, 0], [10, 1], [10.001, 2], [20, 3]]");
  for (int frame = 0; frame <= 20; ++frame) {
    const double weight = weight_at(scene, frame);
    EXPECT_GE(weight, frame <= 10 ? 0 : 2) << "frame " << frame;
    EXPECT_LE(weight, frame <= 10 ? 1 : 3) << "frame " << frame;
  }
}

// Where the object's x axis points at a frame.
glm::dvec3 x_axis_at(const Scene& scene, std::int64_t frame) {
  return glm::dvec3(evaluate(scene.timeline, frame).node_to_world[scene.objects[0].node] * glm::dvec4(1, 0, 0, 0));
}

TEST(ShotTrack, RotationAboutOneAxisTurnsTheWholeWay) {
  const Scene scene = with_track(
      "target = \"rotation\"\n"
      "keys = [[0, { axis = [0, 0, 2], degrees = 0 }], [100, { axis = [0, 0, 2], degrees = 720 }], "
      "[150, { axis = [0, 0, 2], degrees = 450 }]]");
  for (int frame = 0; frame <= 150; ++frame) {
    const double degrees = frame <= 100 ? 7.2 * frame : 720 - 5.4 * (frame - 100), angle = degrees * M_PI / 180;
    const glm::dvec3 x = x_axis_at(scene, frame);
    // The inserted keys lie on whole ticks, a millionth of a frame: their angle is exact, so only rounding is left, of
    // angles up to 720 degrees.
    EXPECT_NEAR(x.x, std::cos(angle), 16 * rounding_bound) << "frame " << frame;
    EXPECT_NEAR(x.y, std::sin(angle), 16 * rounding_bound) << "frame " << frame;
  }
}

TEST(ShotTrack, RotationTakesQuaternionsOfAnyLengthAlongTheShorterArc) {
  // No rotation, then 90 degrees about z, written with the opposite sign and three times the length.
  const Scene scene = with_track("target = \"rotation\"\nkeys = [[0, [0, 0, 0, 1]], [10, [0, 0, -3, -3]]]");
  const glm::dvec3 x = x_axis_at(scene, 5);
  EXPECT_NEAR(x.x, std::sqrt(0.5), rounding_bound);
  EXPECT_NEAR(x.y, std::sqrt(0.5), rounding_bound);
}

TEST(ShotTrack, CubicRotationPassesThroughItsKeysWithoutAFlip) {
  const Scene scene = with_track(
      "target = \"rotation\"\ninterpolation = \"cubic\"\n"
      "keys = [[0, { axis = [0, 0, 1], degrees = 0 }], [10, { axis = [0, 0, 1], degrees = 150 }], "
      "[20, { axis = [0, 0, 1], degrees = 300 }], [30, { axis = [0, 0, 1], degrees = 450 }]]");
  glm::dvec3 before = x_axis_at(scene, 0);
  for (int frame = 1; frame <= 30; ++frame) {
    const glm::dvec3 now = x_axis_at(scene, frame);
    EXPECT_GT(before.x * now.y - before.y * now.x, 0) << "turns on in the same sense, frame " << frame;
    EXPECT_LT(glm::length(now - before), 0.5) << "frame " << frame;  // 15 degrees a frame on average: a chord of 0.26
    before = now;
  }
  EXPECT_NEAR(x_axis_at(scene, 20).x, 0.5, rounding_bound);
}

TEST(ShotTrack, CubicRotationTakesQuaternionsOfEitherSign) {
  const auto turning = [](const char* second) {
    return with_track("target = \"rotation\"\ninterpolation = \"cubic\"\nkeys = [[0, [0, 0, 0, 1]], [10, " +
                      std::string(second) + "], [20, [0, 0, 1, 0]]]");
  };
  const Scene scene = turning("[0, 0, 1, 1]"), negated = turning("[0, 0, -1, -1]");
  for (int frame = 0; frame <= 20; ++frame) EXPECT_EQ(x_axis_at(scene, frame), x_axis_at(negated, frame)) << frame;
}

TEST(ShotTrack, SpringsFollowTheirKeys) {
  const Scene scene = with_track(
      "target = \"morph.cube\"\ninterpolation = \"spring\"\nfrequency = 2\ndamping_ratio = 0.25\n"
      "follows = \"step\"\nkeys = [[0, 0], [5, 1]]");
  EXPECT_EQ(weight_at(scene, 5), 0);
  // From rest towards 1: 1 - e^-at (cos dt + a/d sin dt).
  for (int frame = 6; frame < 60; ++frame) {
    const double t = (frame - 5) / 25.0, omega = 2 * M_PI * 2, a = 0.25 * omega, d = omega * std::sqrt(1 - 0.25 * 0.25);
    EXPECT_NEAR(weight_at(scene, frame), 1 - std::exp(-a * t) * (std::cos(d * t) + a / d * std::sin(d * t)),
                rounding_bound)
        << "frame " << frame;
  }
  // Without a range the last frame is the one by which it has settled: ln 1000 / a = 2.2 s after the key.
  EXPECT_EQ(frame_numbers(scene.frames).back(), 5 + static_cast<int>(std::log(1000) / (M_PI) * 25));
}

TEST(ShotTrack, SpringsFollowLinesByDefault) {
  const Scene scene =
      with_track("target = \"morph.cube\"\ninterpolation = \"spring\"\nfrequency = 1000\nkeys = [[0, 0], [100, 100]]");
  // A stiff spring lags behind a moving target by 2 zeta / omega; the damping ratio is 1/2.
  EXPECT_NEAR(weight_at(scene, 50), 50 - 25 / (2 * M_PI * 1000), rounding_bound * 10);
}

TEST(ShotTrack, ARotationOnASpringTurnsTheWholeWay) {
  const Scene scene = with_track(
      "target = \"rotation\"\ninterpolation = \"spring\"\nfrequency = 100\n"
      "keys = [[0, { axis = [0, 0, 1], degrees = 0 }], [100, { axis = [0, 0, 1], degrees = 720 }]]");
  double turned = 0;
  glm::dvec3 before = x_axis_at(scene, 0);
  for (int frame = 1; frame <= 110; ++frame) {
    const glm::dvec3 now = x_axis_at(scene, frame);
    turned += std::atan2(before.x * now.y - before.y * now.x, glm::dot(before, now));
    before = now;
  }
  EXPECT_NEAR(turned, 4 * M_PI, 1e-6);
}

TEST(ShotTrack, MovesScalesAndHides) {
  const Scene scene = ShotFolder().load(R"(
[[object]]
mesh = "cube"
[[object.track]]
target = "translation"
keys = [[0, [0, 0, 0]], [10, [10, 20, 30]]]
[[object.track]]
target = "scale"
keys = [[0, [2, 3, 4]]]
[[object.track]]
target = "visible"
keys = [[0, true], [3, false], [6.5, 1]]
)");
  const FrameState state = evaluate(scene.timeline, 5);
  const int node = scene.objects[0].node;
  const glm::dvec4 corner = state.node_to_world[node] * glm::dvec4(1, 1, 1, 1);
  EXPECT_EQ(corner, glm::dvec4(5 + 2, 10 + 3, 15 + 4, 1));
  const std::vector<bool> expected = {true, true, true, false, false, false, false, true, true};
  for (std::size_t frame = 0; frame < expected.size(); ++frame)
    EXPECT_EQ(evaluate(scene.timeline, static_cast<std::int64_t>(frame)).node_visible[node] != 0, expected[frame])
        << frame;
}

TEST(ShotTrack, MovesCameraAndLights) {
  const Scene scene = ShotFolder().load(R"(
[camera]
eye = [0, 0, 5]
[[camera.track]]
target = "eye"
keys = [[0, [0, 0, 5]], [10, [5, 0, 0]]]
[[camera.track]]
target = "fovy_degrees"
keys = [[0, 40], [10, 50]]
[[camera.track]]
target = "near"
keys = [[0, 1], [10, 2]]
[[light]]
position = [0, 0, 0]
intensity = 3
[[light.track]]
target = "position"
keys = [[0, [0, 0, 0]], [10, [1, 2, 3]]]
[[light.track]]
target = "color"
keys = [[0, [1, 0, 0]], [10, [0, 1, 0]]]
[[object]]
mesh = "cube"
)");
  const FrameState state = evaluate(scene.timeline, 10);
  const glm::dvec4 origin = state.camera.world_to_eye * glm::dvec4(0, 0, 0, 1);
  EXPECT_NEAR(origin.z, -5, rounding_bound);
  EXPECT_EQ(std::get<Perspective>(state.camera.projection).fovy_degrees, 50);
  EXPECT_EQ(std::get<Perspective>(state.camera.projection).near, 2);
  EXPECT_EQ(state.lights[0].vector, glm::dvec3(1, 2, 3));
  EXPECT_EQ(state.lights[0].color, glm::dvec3(0, 3, 0)) << "keys of a colour are multiplied by the intensity as well";
  EXPECT_EQ(frame_numbers(scene.frames).back(), 10) << "the keys of cameras and lights count as well";
}

}  // namespace
}  // namespace morphcl
