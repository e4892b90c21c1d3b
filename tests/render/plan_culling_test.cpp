// Objects out of view are found by bounds over all time in a hierarchy: no object that may show is lost on the way.
#include <gtest/gtest.h>

#include <algorithm>

#include "anim/timeline_at.hpp"
#include "host/render/frame/frame_plan.hpp"
#include "host/render/plan/motion_bounds.hpp"
#include "host/render/plan/object_tree.hpp"
#include "host/render/plan/view_volume.hpp"
#include "morphcl/planner.hpp"
#include "morphcl/solids.hpp"
#include "morphcl/transform.hpp"
#include "tests/render/scene_builder.hpp"
#include "tests/support/random.hpp"

namespace morphcl::test {
namespace {

using test_support::Random32;

HalfSpaces view_from(const glm::dvec3& eye, Random32& random, const Projection& projection) {
  CompositeTransform turn;
  turn.rotate_about_axis({0, 0, 0}, random.vector() + glm::dvec3(0, 0, 1.5), 180 * random.number());
  const ViewVolume volume = make_view_volume(projection, 160, 90);
  glm::dmat4 to_eye = turn.matrix();
  to_eye[3] = to_eye * glm::dvec4(-eye, 1.0);
  return HalfSpaces(volume.view, volume.eye_to_clip * to_eye);
}

TEST(ObjectTree, FindsWhatIsNotOutsideAndNothingElse) {
  Random32 random(1);
  for (const unsigned count : {0u, 1u, 7u, 8u, 9u, 64u, 65u, 3000u}) {
    std::vector<std::optional<BoundedBox>> boxes;
    for (unsigned i = 0; i < count; ++i) {
      const glm::dvec3 center = random.vector(30), half = glm::abs(random.vector(random.one_in(50) ? 40 : 1));
      if (random.one_in(100))
        boxes.emplace_back();
      else
        boxes.push_back(BoundedBox{center, half, glm::abs(center) + half});
    }
    const ObjectTree tree(boxes);
    ObjectTree::InView found;
    unsigned inside = 0, outside = 0;
    for (int view = 0; view < 20; ++view) {
      const HalfSpaces planes =
          view_from(random.vector(20), random,
                    view % 2 ? Projection(Perspective{60, 0.1, 40}) : Projection(Orthographic{-9, 9, -5, 5, -4, 30}));
      tree.find(planes, found);
      for (unsigned i = 0; i < count; ++i) {
        const Side side = boxes[i] ? planes.side(*boxes[i]) : Side::touching;
        EXPECT_EQ(found.candidates.contains(i), side != Side::outside) << count << " objects, object " << i;
        EXPECT_EQ(found.inside.contains(i), side == Side::inside) << count << " objects, object " << i;
        inside += side == Side::inside;
        outside += side == Side::outside;
      }
    }
    if (count >= 3000) {
      EXPECT_GT(inside, 100u);
      EXPECT_GT(outside, 100u);
    }
  }
}

TEST(ObjectTree, KeepsObjectsApartThatShareOnePlace) {
  const std::vector<std::optional<BoundedBox>> boxes(1000, BoundedBox{{1, 2, -9}, glm::dvec3(0), glm::dvec3(9)});
  const ObjectTree tree(boxes);
  ObjectTree::InView found;
  const ViewVolume volume = make_view_volume(Perspective{60, 0.1, 40}, 160, 90);
  tree.find(HalfSpaces(volume.view, volume.eye_to_clip), found);
  std::vector<std::size_t> objects;
  found.candidates.for_each([&](std::size_t object) { objects.push_back(object); });
  ASSERT_EQ(objects.size(), 1000u);
  for (std::size_t i = 0; i < objects.size(); ++i) EXPECT_EQ(objects[i], i);
}

Track random_track(Random32& random, int width, bool rotation, double reach) {
  const auto kind = static_cast<Interpolation>(random.below(3));
  const int keys = 2 + static_cast<int>(random.below(3));
  std::vector<std::int64_t> ticks;
  std::vector<double> values;
  for (int key = 0; key < keys; ++key) {
    ticks.push_back(key * 7'000'000);
    const int per_key = kind == Interpolation::cubic ? 3 * width : width;
    for (int i = 0; i < per_key; ++i) values.push_back(random.number(reach));
  }
  return Track({kind, width, rotation, 25'000'000, ticks, values});
}

// Chains of few nodes with few tracks keep the bounds tight, so that each part of them is needed somewhere.
TEST(BoundsOverTime, HoldTheObjectAtEveryFrame) {
  Random32 random(5);
  int still = 0, moving = 0;
  for (int trial = 0; trial < 600; ++trial) {
    Timeline timeline;
    const int nodes = 1 + trial % 3, tracks = trial % 4;
    timeline.nodes.resize(static_cast<std::size_t>(nodes));
    for (int i = 0; i < nodes; ++i) {
      Node& node = timeline.nodes[i];
      node.parent = i - 1;
      if (random.one_in(2)) node.translation = random.vector(5);
      if (random.one_in(2)) node.scale = random.vector(2);
      if (random.one_in(2)) node.rotation = {1, random.number(), random.number(), random.number()};
      for (int column = 0; column < 4 && random.one_in(3); ++column)
        node.static_transform[column] += glm::dvec4(random.vector(2), 0.0);
    }
    for (int i = 0; i < tracks; ++i) {
      Node& node = timeline.nodes[random.below(static_cast<unsigned>(nodes))];
      const unsigned kind = random.below(3);
      if (kind == 0) node.translation_track = random_track(random, 3, false, 6);
      if (kind == 1) node.rotation_track = random_track(random, 4, true, 1);
      if (kind == 2) node.scale_track = random_track(random, 3, false, 2);
    }
    validate(timeline);
    const Box box{{2, 1, -0.1}, {2.1, 1.2, 0.1}};
    NodeSampler sampler(timeline.nodes);
    const std::optional<BoundedBox> bounds = bounds_over_time(timeline.nodes, sampler, nodes - 1, box);
    ASSERT_TRUE(bounds);
    (sampler.is_still(nodes - 1) ? still : moving) += 1;
    for (std::int64_t frame = -1; frame < 30; ++frame) {
      sampler.go_to(tick_of(timeline.time, frame));
      for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 p(sampler.to_world(nodes - 1) * glm::dvec4(box.corner(corner), 1.0));
        for (int axis = 0; axis < 3; ++axis) {
          ASSERT_LE(std::abs(p[axis] - bounds->center[axis]), bounds->half[axis]) << trial << ' ' << frame;
          ASSERT_LE(std::abs(p[axis]), bounds->magnitude[axis] * (1 + 1e-12)) << trial << ' ' << frame;
        }
      }
    }
  }
  EXPECT_GT(moving, 100);
  EXPECT_GT(still, 100);
}

AnimatedStep random_step(Random32& random) {
  constexpr StepKind kinds[] = {StepKind::fixed,
                                StepKind::translate,
                                StepKind::scale_about,
                                StepKind::rotate_x_degrees,
                                StepKind::rotate_y_degrees,
                                StepKind::rotate_z_degrees,
                                StepKind::rotate_about_axis};
  AnimatedStep step;
  step.kind = kinds[random.below(7)];
  if (step.kind == StepKind::fixed) {
    const double xy = random.number();
    const double yx = random.number();
    step.constant.shear(xy, 0, yx, 0, 0, 0);
  }
  for (double& parameter : step.parameters) parameter = random.number(3);
  for (int first = 0; first < parameter_count(step.kind); first += 3)
    if (random.one_in(2))
      step.tracks.push_back({first, random_track(random, std::min(3, parameter_count(step.kind) - first), false, 4)});
  const bool scales = step.kind == StepKind::scale_about;
  step.of_axes = random.one_in(2) && !(scales && !step.tracks.empty());
  return step;
}

// Steps that move, two a node.
TEST(BoundsOverTime, HoldTheObjectThatStepsMove) {
  Random32 random(6);
  int moving = 0;
  for (int trial = 0; trial < 600; ++trial) {
    Timeline timeline;
    timeline.nodes.resize(2);
    timeline.nodes[1].parent = 0;
    for (Node& node : timeline.nodes)
      for (int i = 0; i < 2; ++i) node.steps.add_step(random_step(random));
    const Box box{{2, 1, -0.1}, {2.1, 1.2, 0.1}};
    NodeSampler sampler(timeline.nodes);
    const std::optional<BoundedBox> bounds = bounds_over_time(timeline.nodes, sampler, 1, box);
    ASSERT_TRUE(bounds);
    moving += sampler.is_still(1) ? 0 : 1;
    for (std::int64_t frame = -1; frame < 30; ++frame) {
      sampler.go_to(tick_of(timeline.time, frame));
      for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 p(sampler.to_world(1) * glm::dvec4(box.corner(corner), 1.0));
        for (int axis = 0; axis < 3; ++axis)
          ASSERT_LE(std::abs(p[axis] - bounds->center[axis]), bounds->half[axis]) << trial << ' ' << frame;
      }
    }
  }
  EXPECT_GT(moving, 500);
}

TEST(BoundsOverTime, OfStepsWithoutABoundAreUnknown) {
  Timeline timeline;
  timeline.nodes.resize(1);
  AnimatedStep shear{StepKind::shear};
  shear.tracks.push_back({0, Track({Interpolation::step, 1, false, 25, {0, 1}, {0, 1}})});
  timeline.nodes[0].steps.add_step(shear);
  const NodeSampler sampler(timeline.nodes);
  EXPECT_FALSE(bounds_over_time(timeline.nodes, sampler, 0, Box{{0, 0, 0}, {1, 1, 1}}));
}

TEST(BoundsOverTime, OfWhatMayOverflowOrMovesTooDeepAreUnknown) {
  Timeline timeline;
  timeline.nodes.resize(70);
  for (int i = 0; i < 70; ++i) timeline.nodes[i].parent = i - 1;
  timeline.nodes[0].scale_track = Track({Interpolation::step, 3, false, 25, {0}, {1, 1, 1}});
  const NodeSampler sampler(timeline.nodes);
  const Box box{{0, 0, 0}, {1, 1, 1}};
  EXPECT_TRUE(bounds_over_time(timeline.nodes, sampler, 63, box));
  EXPECT_FALSE(bounds_over_time(timeline.nodes, sampler, 64, box));
  timeline.nodes[0].scale_track =
      Track({Interpolation::cubic, 3, false, 1, {0, 1000}, {0, 0, 0, 1, 1, 1, 1e308, 0, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0}});
  EXPECT_FALSE(bounds_over_time(timeline.nodes, sampler, 0, box));
}

TEST(WeightRanges, FollowTheLastTrackOfATarget) {
  MorphWeights morph;
  morph.weights = {0.25, 0, 0};
  const auto track = [](std::vector<double> values, int width) {
    return Track({Interpolation::linear, width, false, 25, {0, 10}, std::move(values)});
  };
  morph.tracks = {{1, track({-5, 0, 5, 1}, 2)}, {1, track({0.5, 0.75}, 1)}};
  std::vector<Interval> ranges;
  weight_ranges(morph, ranges);
  ASSERT_EQ(ranges.size(), 3u);
  EXPECT_EQ(ranges[0].lower, 0.25);
  EXPECT_EQ(ranges[0].upper, 0.25);
  EXPECT_NEAR(ranges[1].lower, 0.5, 1e-9);
  EXPECT_NEAR(ranges[1].upper, 0.75, 1e-9);
  EXPECT_NEAR(ranges[2].upper, 1, 1e-9);
}

// A frame's plan does not depend on the frames that were planned before it, nor on when it is made.
TEST(Planner, PlansAFrameTheSameWheneverItIsAskedTo) {
  Random32 random(9);
  SceneBuilder b(160, 90);
  for (int i = 0; i < 300; ++i) {
    b.add(make_pyramid_to_cube(), Shading::flat, place(random.vector(8), 0.004));
    Scene& scene = b.scene();
    if (i % 3 == 0) scene.timeline.nodes.back().rotation_track = random_track(random, 4, true, 1);
    if (i % 5 == 0) scene.timeline.nodes.back().visible_track = random_track(random, 1, false, 1);
    if (i % 2 == 0) scene.objects.back().morph.tracks.push_back({0, random_track(random, 1, false, 1)});
  }
  b.look({0, 0, 4}).scene().timeline.camera.target_track = random_track(random, 3, false, 4);
  const Planner planner(b.scene());
  std::size_t max = 0;
  for (const std::int64_t frame : {3, 17, 4, 4, 0, 17, 28}) {
    const Plan again = planner.plan(frame), alone = plan_frame(b.scene(), frame);
    ASSERT_EQ(again->draws.size(), alone->draws.size()) << "frame " << frame;
    EXPECT_EQ(again->clips, alone->clips);
    for (std::size_t i = 0; i < alone->draws.size(); ++i) {
      EXPECT_EQ(again->draws[i].object, alone->draws[i].object);
      EXPECT_EQ(again->draws[i].object_to_clip, alone->draws[i].object_to_clip);
      EXPECT_EQ(again->draws[i].normal_to_eye, alone->draws[i].normal_to_eye);
      EXPECT_TRUE(std::equal(again->draws[i].targets.begin(), again->draws[i].targets.end(),
                             alone->draws[i].targets.begin(), alone->draws[i].targets.end()));
      EXPECT_TRUE(i == 0 || alone->draws[i - 1].object < alone->draws[i].object) << "drawn in the scene's order";
    }
    max = std::max(max, alone->draws.size());
  }
  EXPECT_GT(max, 10u);
}

}  // namespace
}  // namespace morphcl::test
