#include "morphcl/animated_transform.hpp"

#include <utility>

#include "morphcl/track.hpp"
#include "tests/math/check.hpp"

namespace morphcl {
namespace {

constexpr TimeBase film;

Track linear(std::vector<double> values) {
  const int width = static_cast<int>(values.size() / 2);
  return Track(
      {Interpolation::linear, width, false, film.ticks_per_second(), {0, film.frame_ticks(720)}, std::move(values)});
}

// The classic turn: half a degree a frame about the line from the origin to (1, 0, 1).
AnimatedTransform half_a_degree_a_frame() {
  AnimatedTransform turn;
  turn.fixed(CompositeTransform().scale_about({100, 100, 30}, {0.01, 0.01, 0.01}));
  turn.rotate_about_axis({0, 0, 0}, {1, 0, 1}, linear({0, 360}));
  return turn;
}

TEST(AnimatedTransform, IsTheCompositeOfItsParametersAtTheTime) {
  const AnimatedTransform turn = half_a_degree_a_frame();
  for (const int frame : {0, 1, 60, 180, 719, 720}) {
    const CompositeTransform expected = CompositeTransform()
                                            .scale_about({100, 100, 30}, {0.01, 0.01, 0.01})
                                            .rotate_about_axis({0, 0, 0}, {1, 0, 1}, 0.5 * frame);
    EXPECT_EQ(turn.at(film.frame_ticks(frame)).matrix(), expected.matrix()) << "frame " << frame;
  }
  EXPECT_EQ(turn.at(film.frame_ticks(60)).to_string(),
            "1. scale_about point (100, 100, 30) by (0.01, 0.01, 0.01)\n"
            "2. rotate_about_axis from (0, 0, 0) to (1, 0, 1), 30 degrees\n");
}

TEST(AnimatedTransform, FullTurnIsTheStartingPoseBitForBit) {
  const AnimatedTransform turn = half_a_degree_a_frame();
  EXPECT_EQ(turn.at(0).matrix(), turn.at(film.frame_ticks(720)).matrix());
}

TEST(AnimatedTransform, EveryKindOfStep) {
  AnimatedTransform all;
  all.translate(linear({0, 0, 0, 2, 4, 6}))
      .scale_about({1, 1, 1}, linear({1, 1, 1, 3, 5, 7}))
      .shear(linear({0, 0, 0, 0, 0, 0, 1, 2, 3, 4, 5, 6}));
  const CompositeTransform expected =
      CompositeTransform().translate({1, 2, 3}).scale_about({1, 1, 1}, {2, 3, 4}).shear(0.5, 1, 1.5, 2, 2.5, 3);
  EXPECT_EQ(all.at(film.frame_ticks(360)).matrix(), expected.matrix());
}

TEST(AnimatedTransform, BadTracksAndDegenerateParametersAreErrors) {
  AnimatedTransform t;
  expect_error([&] { t.translate(linear({0, 1})); }, ErrorKind::usage, "translate: its track has 1");
  expect_error([&] { t.shear(Track()); }, ErrorKind::usage, "shear: its track has 0");
  t.rotate_about_axis({1, 1, 1}, {1, 1, 1}, linear({0, 1}));
  expect_error([&] { t.at(0); }, ErrorKind::usage, "two different points");
}

TEST(AnimatedTransform, AnyParameterOfAStepMayMove) {
  AnimatedStep turn{StepKind::rotate_about_axis, {0, 0, 0, 1, 0, 1, 0}};
  turn.tracks.push_back({0, linear({0, 0, 0, 2, 4, 6})});
  turn.tracks.push_back({6, linear({0, 60})});
  AnimatedTransform moving;
  moving.add_step(turn);
  EXPECT_TRUE(moving.moves());
  EXPECT_EQ(moving.at(film.frame_ticks(360)).matrix(),
            CompositeTransform().rotate_about_axis({1, 2, 3}, {1, 0, 1}, 30).matrix());
  turn.of_axes = true;
  AnimatedTransform axes;
  axes.add_step(turn);
  EXPECT_EQ(axes.at(film.frame_ticks(360)).matrix(),
            CompositeTransform().rotate_about_axis({1, 2, 3}, {1, 0, 1}, -30).matrix());
}

TEST(AnimatedTransform, TracksThatDriveNothingAreErrors) {
  AnimatedTransform t;
  const auto with = [&](int first, Track track) {
    AnimatedStep step{StepKind::translate};
    step.tracks.push_back({first, std::move(track)});
    return [&t, step] { t.add_step(step); };
  };
  expect_error(with(1, linear({0, 0, 0, 1, 1, 1})), ErrorKind::usage, "from parameter 1 on");
  expect_error(with(-1, linear({0, 1})), ErrorKind::usage, "from parameter -1 on");
  expect_error(with(0, Track()), ErrorKind::usage, "needs a track that is neither empty");
}

}  // namespace
}  // namespace morphcl
