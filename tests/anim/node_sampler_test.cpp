// The sampler gives evaluate()'s numbers, whatever is asked for and in whatever order.
#include "anim/node_sampler.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "anim/timeline_at.hpp"
#include "morphcl/error.hpp"

namespace morphcl {
namespace {

// A forest in which every kind of track and of standing still occurs at every depth; parents come after their children
// as well as before them.
Timeline forest(unsigned seed, int count) {
  Timeline timeline;
  std::mt19937 random(seed);
  const auto number = [&] { return std::uniform_real_distribution<double>(-1, 1)(random); };
  const auto one_in = [&](int n) { return random() % static_cast<unsigned>(n) == 0; };
  const auto track = [&](int width, bool rotation, std::vector<double> values) {
    return Track({Interpolation::linear, width, rotation, 25'000'000, {0, 10'000'000}, std::move(values)});
  };
  timeline.nodes.resize(static_cast<std::size_t>(count));
  std::vector<int> place(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) place[i] = i;
  std::shuffle(place.begin(), place.end(), random);
  for (int i = 0; i < count; ++i) {
    Node& node = timeline.nodes[place[i]];
    if (i > 0 && !one_in(5)) node.parent = place[random() % static_cast<unsigned>(i)];
    node.translation = {number(), number(), number()};
    node.rotation = {number(), number(), number(), 1.0};
    node.static_transform[3] = {number(), number(), number(), 1.0};
    if (one_in(8))
      node.translation_track = track(3, false, {number(), number(), number(), number(), number(), number()});
    if (one_in(8)) node.rotation_track = track(4, true, {number(), number(), number(), 1, 0, number(), number(), 1});
    if (one_in(8)) node.scale_track = track(3, false, {1, 1, 1, number(), number(), number()});
    if (one_in(8)) node.visible_track = track(1, false, {number() + 0.5, number() + 0.5});
  }
  validate(timeline);
  return timeline;
}

TEST(NodeSampler, GivesTheNumbersOfTheWholeStateInAnyOrder) {
  const Timeline timeline = forest(1, 300);
  NodeSampler sampler(timeline.nodes);
  std::mt19937 random(2);
  int hidden = 0, still = 0, moving = 0;
  for (const std::int64_t frame : {0, 7, 3, 3, 10, 25, -4}) {
    const FrameState state = evaluate(timeline, frame);
    sampler.go_to(tick_of(timeline.time, frame));
    for (int i = 0; i < 200; ++i) {
      const int node = static_cast<int>(random() % 300);
      ASSERT_EQ(sampler.to_world(node), state.node_to_world[node]) << "frame " << frame << " node " << node;
      ASSERT_EQ(sampler.is_visible(node), state.node_visible[node] != 0) << "frame " << frame << " node " << node;
      if (sampler.is_still(node)) {
        ASSERT_EQ(sampler.still_to_world(node), state.node_to_world[node]);
      }
      hidden += !sampler.is_visible(node);
      still += sampler.is_still(node);
      moving += !sampler.is_still(node);
    }
  }
  EXPECT_GT(hidden, 100);
  EXPECT_GT(still, 100);
  EXPECT_GT(moving, 100);
}

TEST(NodeSampler, NodesBelowOneThatMovesAreNotStill) {
  Timeline timeline;
  timeline.nodes.resize(3);
  timeline.nodes[0].parent = 2;
  timeline.nodes[1].parent = -1;
  timeline.nodes[2].scale_track = Track({Interpolation::step, 3, false, 25'000'000, {0}, {1, 2, 3}});
  NodeSampler sampler(timeline.nodes);
  EXPECT_FALSE(sampler.is_still(0));
  EXPECT_TRUE(sampler.is_still(1));
  EXPECT_FALSE(sampler.is_still(2));
}

TEST(NodeSampler, AChainOfAMillionMovingNodes) {
  Timeline timeline;
  constexpr int depth = 1'000'000;
  timeline.nodes.resize(depth);
  for (int i = 0; i < depth; ++i) {
    timeline.nodes[i].parent = i - 1;
    timeline.nodes[i].translation = {1, 0, 0};
  }
  timeline.nodes[0].translation_track =
      Track({Interpolation::linear, 3, false, 25'000'000, {0, 10'000'000}, {1, 0, 0, 11, 0, 0}});
  NodeSampler sampler(timeline.nodes);
  sampler.go_to(tick_of(timeline.time, 5));
  EXPECT_EQ(sampler.to_world(depth - 1)[3], glm::dvec4(depth + 5, 0, 0, 1));
  EXPECT_TRUE(sampler.is_visible(depth - 1));
}

TEST(NodeSampler, AnOverflowIsAnErrorOfWhoAsksForIt) {
  Timeline timeline;
  timeline.nodes.resize(3);
  timeline.nodes[0].scale = timeline.nodes[1].scale = glm::dvec3(1e300);
  timeline.nodes[1].parent = 0;
  timeline.nodes[1].name = "huge";
  NodeSampler sampler(timeline.nodes);
  sampler.go_to(0);
  EXPECT_NO_THROW(sampler.to_world(0));
  EXPECT_NO_THROW(sampler.to_world(2));
  EXPECT_FALSE(sampler.is_still(1));
  try {
    sampler.to_world(1);
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::bad_input);
    EXPECT_EQ(error.place(), "nodes[1] huge");
  }
}

}  // namespace
}  // namespace morphcl
