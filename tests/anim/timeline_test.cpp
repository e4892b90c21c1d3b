#include "morphcl/timeline.hpp"

#include <limits>

#include "morphcl/camera.hpp"
#include "morphcl/transform.hpp"
#include "tests/math/check.hpp"

namespace morphcl {
namespace {

using reference::u64;

constexpr std::int64_t one_frame = 1'000'000;  // ticks at 25 fps

Track linear(int width, std::vector<double> values, std::int64_t first_frame = 0, std::int64_t last_frame = 100) {
  return Track({Interpolation::linear,
                width,
                false,
                25 * one_frame,
                {first_frame * one_frame, last_frame * one_frame},
                std::move(values)});
}

Track step(std::vector<double> values) {
  return Track({Interpolation::step, 1, false, 25 * one_frame, {0, 10 * one_frame}, std::move(values)});
}

Node node_at(const glm::dvec3& translation, int parent) {
  Node node;
  node.translation = translation;
  node.parent = parent;
  return node;
}

TEST(Timeline, NodesFollowTheirParents) {
  Timeline timeline;
  timeline.nodes = {node_at({1, 0, 0}, 1), node_at({0, 2, 0}, 2), node_at({0, 0, 3}, -1)};
  timeline.nodes[2].rotation = {std::sqrt(0.5), 0, 0, std::sqrt(0.5)};  // 90 degrees about z
  timeline.nodes[2].scale = {2, 2, 2};
  validate(timeline);
  const FrameState state = evaluate(timeline, 0);
  EXPECT_EQ(glm::dvec3(state.node_to_world[2][3]), glm::dvec3(0, 0, 3));
  EXPECT_EQ(glm::dvec3(state.node_to_world[1][3]), glm::dvec3(-4, 0, 3));
  EXPECT_EQ(glm::dvec3(state.node_to_world[0][3]), glm::dvec3(-4, 2, 3));
}

TEST(Timeline, MillionDeepChainIsEvaluated) {
  Timeline timeline;
  constexpr int depth = 1'000'000;
  timeline.nodes.reserve(depth);
  for (int i = 0; i < depth; ++i) timeline.nodes.push_back(node_at({1, 0, 0}, i + 1 < depth ? i + 1 : -1));
  validate(timeline);
  EXPECT_EQ(evaluate(timeline, 3).node_to_world[0][3], glm::dvec4(depth, 0, 0, 1));
}

TEST(Timeline, TracksReplaceConstantsAndTheStaticTransformComesFirst) {
  Timeline timeline;
  Node node;
  node.translation = {9, 9, 9};
  node.static_transform = CompositeTransform().translate({1, 0, 0}).matrix();
  node.scale_track = linear(3, {1, 1, 1, 3, 3, 3});
  node.translation_track = linear(3, {0, 0, 0, 10, 20, 30});
  node.rotation_track = Track({Interpolation::step, 4, true, 25 * one_frame, {0}, {0, 0, 1, 1}});
  timeline.nodes = {node};
  validate(timeline);
  const glm::dmat4 m = evaluate(timeline, 50).node_to_world[0];
  // (1, 0, 0) scaled by 2, turned to y, moved by (5, 10, 15).
  EXPECT_EQ(m[3], glm::dvec4(5, 12, 15, 1));
}

TEST(Timeline, HiddenNodesHideWhatIsBelow) {
  Timeline timeline;
  timeline.nodes = {node_at({}, -1), node_at({}, 0), node_at({}, 1), node_at({}, -1)};
  timeline.nodes[0].visible_track = step({1, 0.25});
  timeline.nodes[2].visible_track = step({0.5, 1});
  validate(timeline);
  EXPECT_EQ(evaluate(timeline, 9).node_visible, (std::vector<char>{1, 1, 1, 1}));
  EXPECT_EQ(evaluate(timeline, 10).node_visible, (std::vector<char>{0, 0, 0, 1}));
}

TEST(Timeline, LaterWeightTracksOverrideEarlierOnes) {
  Timeline timeline;
  MorphWeights morph;
  morph.weights = {0.125, 0.25, 0.5, 0.75};
  morph.tracks = {{1, linear(2, {0, 0, 1, 2})}, {2, linear(1, {7, 7})}};
  validate(morph);
  EXPECT_EQ(weights_at(morph, timeline.time, 37), (std::vector<double>{0.125, 0.37, 7, 0.75}));
  EXPECT_TRUE(weights_at({}, timeline.time, 37).empty());
}

TEST(Timeline, FrameIsAPureFunctionOfItsNumber) {
  Timeline timeline;
  timeline.nodes = {node_at({}, -1)};
  timeline.nodes[0].translation_track = linear(3, {0.1, 0, 0, 0.7, 3, 9});
  timeline.camera.eye_track = linear(3, {0, 0, 5, 3, 2, 8});
  const FrameState alone = evaluate(timeline, 57);
  for (std::int64_t frame = 0; frame <= 100; ++frame) evaluate(timeline, frame);
  const FrameState again = evaluate(timeline, 57);
  EXPECT_EQ(alone.node_to_world[0], again.node_to_world[0]);
  EXPECT_EQ(alone.camera.world_to_eye, again.camera.world_to_eye);
}

TEST(TimelineCamera, LooksAtItsTarget) {
  Timeline timeline;
  timeline.camera.eye_track = linear(3, {0, 0, 10, 10, 0, 10});
  timeline.camera.target = {0, 0, 1};
  timeline.camera.fovy_track = linear(1, {30, 60});
  timeline.camera.far_track = linear(1, {100, 300});
  validate(timeline);
  const FrameState state = evaluate(timeline, 50);
  EXPECT_EQ(state.camera.world_to_eye, look_at({5, 0, 10}, {0, 0, 1}, {0, 1, 0}).world_to_eye);
  EXPECT_EQ(std::get<Perspective>(state.camera.projection).fovy_degrees, 45);
  EXPECT_EQ(far_distance(state.camera.projection), 200);
  EXPECT_FALSE(state.camera.up_replaced);
}

TEST(TimelineCamera, SitsInItsNodeWhateverItsScale) {
  Timeline timeline;
  timeline.nodes = {node_at({1, 2, 3}, -1)};
  timeline.nodes[0].rotation = {std::sqrt(0.5), 0, std::sqrt(0.5), 0};  // 90 degrees about y: looks along -x
  timeline.camera.node = 0;
  const glm::dmat4 expected = look_at({1, 2, 3}, {0, 2, 3}, {0, 1, 0}).world_to_eye;
  EXPECT_EQ(evaluate(timeline, 0).camera.world_to_eye, expected);
  timeline.nodes[0].scale = {4, 0.5, 16};
  validate(timeline);
  EXPECT_EQ(evaluate(timeline, 0).camera.world_to_eye, expected);
}

TEST(TimelineCamera, DegenerateFrameIsNamed) {
  Timeline timeline;
  timeline.camera.eye_track = linear(3, {0, 0, 5, 0, 0, -5});
  EXPECT_NO_THROW(evaluate(timeline, 49));
  expect_error([&] { evaluate(timeline, 50); }, ErrorKind::bad_input, "frame 50: the camera's eye and target");
  timeline.camera.eye_track = Track();
  timeline.camera.near_track = linear(1, {1, -1});
  expect_error([&] { evaluate(timeline, 75); }, ErrorKind::bad_input, "frame 75: near is -0.5");
  timeline.camera.near_track = Track();
  timeline.nodes = {node_at({}, -1)};
  timeline.nodes[0].scale_track = linear(3, {1, 1, 1, 0, 0, 0});
  timeline.camera.node = 0;
  expect_error([&] { evaluate(timeline, 100); }, ErrorKind::bad_input, "frame 100: the camera's direction is 0");
}

TEST(TimelineCamera, UpAlongTheViewIsReported) {
  Timeline timeline;
  timeline.camera.eye_track = linear(3, {0, 0, 5, 0, 5, 0}, 0, 1);
  EXPECT_FALSE(evaluate(timeline, 0).camera.up_replaced);
  EXPECT_TRUE(evaluate(timeline, 1).camera.up_replaced);
}

TEST(TimelineLights, DirectionsAreUnitAndPositionsAreKept) {
  Timeline timeline;
  Light sun, lamp;
  sun.vector = {3, 0, 4};
  lamp.kind = LightKind::point;
  lamp.vector_track = linear(3, {0, 0, 0, 10, 20, 30});
  lamp.color_track = linear(3, {0, 0, 0, 4, 4, 4});
  lamp.falloff = true;
  timeline.lights = {sun, lamp};
  validate(timeline);
  const FrameState state = evaluate(timeline, 25);
  expect_point(state.lights[0].vector, {0.6, 0, 0.8}, 4 * u64, "sun");
  EXPECT_EQ(state.lights[1].vector, glm::dvec3(2.5, 5, 7.5));
  EXPECT_EQ(state.lights[1].color, glm::dvec3(1));
  EXPECT_TRUE(state.lights[1].falloff);
  timeline.lights[0].vector_track = linear(3, {0, 0, 1, 0, 0, -1});
  expect_error([&] { evaluate(timeline, 50); }, ErrorKind::bad_input, "frame 50: the direction is 0 0 0");
}

TEST(Timeline, OverflowingMotionIsAnErrorThatNamesFrameAndNode) {
  Timeline timeline;
  timeline.nodes = {node_at({}, -1), node_at({}, 0)};
  for (Node& node : timeline.nodes) node.scale_track = linear(3, {1, 1, 1, 1e300, 1e300, 1e300});
  EXPECT_NO_THROW(evaluate(timeline, 0));
  expect_error([&] { evaluate(timeline, 60); }, ErrorKind::bad_input, "nodes[1]");
  expect_error([&] { evaluate(timeline, 60); }, ErrorKind::bad_input, "frame 60");
  expect_error([&] { evaluate(timeline, 1'000'001); }, ErrorKind::usage, "frame 1000001");
  expect_error([&] { evaluate(timeline, std::numeric_limits<std::int64_t>::min()); }, ErrorKind::usage, "out of range");
}

TEST(MorphWeightsValidate, NamesWhatIsWrong) {
  const auto refuses = [](auto change, const char* part) {
    MorphWeights morph;
    morph.weights = {0, 0};
    EXPECT_NO_THROW(validate(morph));
    change(morph);
    expect_error([&] { validate(morph); }, ErrorKind::bad_input, part);
  };
  const double nan = std::nan("");
  refuses([](MorphWeights& morph) { morph.tracks = {{1, linear(2, {0, 0, 0, 0})}}; }, "weights: a track of 2");
  refuses([](MorphWeights& morph) { morph.tracks = {{-1, linear(1, {0, 0})}}; }, "from target -1");
  refuses([](MorphWeights& morph) { morph.tracks = {{std::numeric_limits<int>::max(), linear(1, {0, 0})}}; },
          "do not exist");
  refuses([&](MorphWeights& morph) { morph.weights[1] = nan; }, "weight 1");
}

TEST(TimelineValidate, NamesWhatIsWrong) {
  const auto refuses = [](auto change, const char* part) {
    Timeline timeline;
    timeline.nodes = {node_at({}, -1), node_at({}, 0)};
    timeline.nodes[1].name = "arm";
    timeline.lights = {{}};
    EXPECT_NO_THROW(validate(timeline));
    change(timeline);
    expect_error([&] { validate(timeline); }, ErrorKind::bad_input, part);
  };
  const double nan = std::nan("");
  refuses([](Timeline& t) { t.nodes[0].parent = 1; }, "2 nodes are each other's parents");
  refuses([](Timeline& t) { t.nodes[0].parent = 2; }, "nodes[0]: parent 2");
  refuses([](Timeline& t) { t.nodes[1].translation_track = linear(2, {0, 0, 0, 0}); },
          "nodes[1] arm: the translation track");
  refuses([](Timeline& t) { t.nodes[1].rotation_track = linear(4, {0, 0, 0, 1, 0, 0, 0, 1}); },
          "must be a rotation track");
  refuses([](Timeline& t) { t.nodes[1].scale_track = linear(1, {0, 0}); }, "the scale track has 1");
  refuses([](Timeline& t) { t.nodes[1].visible_track = linear(3, {0, 0, 0, 0, 0, 0}); }, "the visible track has 3");
  refuses([&](Timeline& t) { t.nodes[1].translation.y = nan; }, "translation is NaN");
  refuses([&](Timeline& t) { t.nodes[1].static_transform[2][1] = nan; }, "static_transform is NaN");
  refuses([](Timeline& t) { t.nodes[1].static_transform[2][3] = 1; }, "0 0 0 1");
  refuses([](Timeline& t) { t.nodes[1].rotation = {0, 0, 0, 0}; }, "rotation is 0 0 0 0");
  refuses([](Timeline& t) { t.camera.node = 2; }, "camera: node 2");
  refuses([](Timeline& t) { t.camera.node = -2; }, "camera: node -2");
  refuses([](Timeline& t) { t.camera.up_track = linear(1, {0, 0}); }, "the up track has 1");
  refuses([](Timeline& t) { t.camera.near_track = linear(2, {0, 0, 0, 0}); }, "the near track has 2");
  refuses([&](Timeline& t) { t.camera.eye.x = nan; }, "eye is NaN");
  refuses(
      [](Timeline& t) {
        t.camera.projection = Orthographic{};
        t.camera.fovy_track = linear(1, {30, 60});
      },
      "fovy track");
  refuses([](Timeline& t) { t.lights[0].color_track = linear(1, {0, 0}); }, "lights[0]: the color track");
  refuses([&](Timeline& t) { t.lights[0].vector.z = nan; }, "vector is NaN");
  refuses([&](Timeline& t) { t.ambient.x = nan; }, "ambient");
  refuses([](Timeline& t) { t.time.fps_numerator = 0; }, "frame rate of 0/1");
  refuses([](Timeline& t) { t.time.fps_denominator = 1'000'001; }, "frame rate of 25/1000001");
}

}  // namespace
}  // namespace morphcl
