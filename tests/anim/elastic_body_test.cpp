// Elastic bodies whose springs differ by a factor of 1e12, against the exact motion.
#include "anim/elastic_body.hpp"

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "anim/modal_body.hpp"
#include "anim/stepped_body.hpp"
#include "tests/anim/chain_reference.hpp"
#include "tests/math/check.hpp"

namespace morphcl {
namespace {

using reference::chain_drive;
using reference::chain_time;
using reference::stiff_chain;
using reference::u64;

constexpr int frames = 24;

double largest_error(ElasticBody& body, const std::vector<std::vector<reference::Exact>>& motion) {
  double worst = 0;
  Displacements x;
  for (int k = 0; k <= frames; ++k) {
    body.displacements_at(k, x);
    for (std::size_t i = 0; i < x.size(); ++i) {
      const reference::Exact& exact = motion[static_cast<std::size_t>(k)][i];
      worst = std::max(worst, std::abs(exact.error_of(x[i].x)));
      EXPECT_EQ(x[i].z, -2 * x[i].x);
      EXPECT_EQ(x[i].y, 0);
    }
  }
  return worst;
}

TEST(ElasticBody, ModalChainEqualsTheReference) {
  ModalBody body(stiff_chain(8), EdgeRest::base, chain_drive(8, frames), chain_time);
  const auto expect = [&](int frame, const std::array<const char*, 8>& digits) {
    Displacements x;
    body.displacements_at(frame, x);
    for (std::size_t i = 0; i < 8; ++i)
      EXPECT_TRUE(within(x[i].x, reference::decimal(digits[i]), 1e-12)) << "frame " << frame << ", mass " << i;
  };
  expect(1,
         {"0.000354251776392911438", "0.000399254944158300983", "0.000513302010191240949", "0.000560851745917402626",
          "0.000561542017280486888", "0.000561549540959579645", "0.000561549606742621993", "0.000561549607149662193"});
  expect(12, {"0.0482766439790372202", "0.0710626880547427896", "0.0719492256363308883", "0.0719986850230615385",
              "0.0719993492701720829", "0.0719993565908712138", "0.0719993566553005969", "0.0719993566557008688"});
  expect(24, {"0.140273797074951837", "0.201202100698073922", "0.203441814308827188", "0.203433295466098007",
              "0.203433264195255262", "0.203433264196685947", "0.203433264198258061", "0.203433264198273734"});
}

// The modes are found to a few u relative, each step of a spring adds a few u: 1e-12 for 24 frames of motions up to 2.
TEST(ElasticBody, ModalIsExactForAnyStiffness) {
  for (const std::size_t masses : {3, 8, 16}) {
    const SpringNet net = stiff_chain(masses);
    ModalBody body(net, EdgeRest::base, chain_drive(masses, frames), chain_time);
    const double error = largest_error(body, reference::chain_motion(net, frames));
    EXPECT_LT(error, 1e-12) << masses;
    std::printf("modal, %zu masses: largest error %.2g\n", masses, error);
  }
}

TEST(ElasticBody, SteppedIsWithinATenThousandth) {
  for (const std::size_t masses : {3, 8, 16}) {
    const SpringNet net = stiff_chain(masses);
    SteppedBody body(net, EdgeRest::base, chain_drive(masses, frames), chain_time);
    const double error = largest_error(body, reference::chain_motion(net, frames));
    EXPECT_LT(error, 1e-4) << masses;
    std::printf("TR-BDF2, %zu masses: largest error %.2g\n", masses, error);
  }
}

TEST(ElasticBody, EdgesThatFollowLeaveTheTargetsWhereTheyAre) {
  const SpringNet net = stiff_chain(8);
  MorphDrive drive = chain_drive(8, frames);
  for (const bool modal : {true, false}) {
    std::unique_ptr<ElasticBody> body;
    if (modal)
      body = std::make_unique<ModalBody>(net, EdgeRest::driven, drive, chain_time);
    else
      body = std::make_unique<SteppedBody>(net, EdgeRest::driven, drive, chain_time);
    Displacements x, wanted(8);
    drive.displacements_at(chain_time.frame_ticks(frames), wanted);
    body->displacements_at(frames + 24 * 40, x);  // e^-40 is left
    for (std::size_t i = 0; i < 8; ++i) EXPECT_TRUE(within(x[i].x, wanted[i].x, 1e-12)) << modal << ", mass " << i;
  }
}

TEST(ElasticBody, BothMethodsAgreeWhereSpringsAreSoft) {
  SpringNet net = stiff_chain(6);
  for (SpringNet::Edge& edge : net.edges) edge.stiffness = 20;
  net.edges.push_back({0, 3, 50});
  for (const EdgeRest rest : {EdgeRest::driven, EdgeRest::base}) {
    ModalBody modal(net, rest, chain_drive(6, frames), chain_time);
    SteppedBody stepped(net, rest, chain_drive(6, frames), chain_time);
    Displacements exact, x;
    for (const int k : {-3, 0, 1, 7, 24, 40}) {
      modal.displacements_at(k, exact);
      stepped.displacements_at(k, x);
      // Second order: (omega h)^2 of the displacement, with omega^2 up to 140 and h = 1/384.
      for (std::size_t i = 0; i < 6; ++i) EXPECT_TRUE(within(x[i].x, exact[i].x, 140.0 / 384 / 384)) << k << ", " << i;
    }
  }
}

TEST(ElasticBody, WithoutEdgesEveryMassIsASpring) {
  SpringNet net = stiff_chain(5);
  net.edges.clear();
  net.anchor = 300;
  const MorphDrive drive = chain_drive(5, frames);
  ModalBody body(net, EdgeRest::base, drive, chain_time);
  const Spring spring{std::sqrt(300.0), 0.5 * (2 / std::sqrt(300.0) + 1e-8 * std::sqrt(300.0))};
  const SpringMotion alone(spring, drive.weights.tracks[0].track);
  Displacements x;
  for (int k = 0; k < 60; ++k) {
    double followed = 0;
    alone.evaluate(drive.weights.tracks[0].track, chain_time.frame_ticks(k), &followed);
    body.displacements_at(k, x);
    for (std::size_t i = 0; i < 5; ++i)
      EXPECT_TRUE(within(x[i].x, followed * drive.targets[0][i].x, 16 * u64)) << k << ", " << i;
  }
}

TEST(ElasticBody, RestsBeforeItsFirstKey) {
  SpringNet net = stiff_chain(4);
  MorphDrive drive = chain_drive(4, 10);
  std::vector<std::int64_t> ticks = {chain_time.frame_ticks(5), chain_time.frame_ticks(6)};
  drive.weights.tracks[0].track =
      Track({Interpolation::linear, 1, false, chain_time.ticks_per_second(), ticks, {1, 1}});
  for (const EdgeRest rest : {EdgeRest::driven, EdgeRest::base}) {
    SteppedBody stepped(net, rest, drive, chain_time);
    ModalBody modal(net, rest, drive, chain_time);
    Displacements x, first;
    modal.displacements_at(-100, first);
    for (const int k : {-100, 5, 6, 50}) {
      modal.displacements_at(k, x);
      for (std::size_t i = 0; i < 4; ++i) EXPECT_TRUE(within(x[i].x, first[i].x, 64 * u64)) << k;
      stepped.displacements_at(k, x);
      for (std::size_t i = 0; i < 4; ++i) EXPECT_TRUE(within(x[i].x, first[i].x, 1e-9)) << k;
    }
  }
}

// Whatever was asked for before, and however few states are kept.
TEST(ElasticBody, AFrameAloneIsThatOfTheSequence) {
  const auto make = [](std::size_t kept_bytes) {
    return SteppedBody(stiff_chain(8), EdgeRest::driven, chain_drive(8, 60), chain_time, kept_bytes);
  };
  std::vector<Displacements> sequence(90);
  SteppedBody all = make(SteppedBody::max_kept_bytes);
  for (std::size_t k = 0; k < 90; ++k) all.displacements_at(static_cast<std::int64_t>(k), sequence[k]);
  SteppedBody few = make(5 * 8 * 48);
  Displacements x;
  for (const std::int64_t k : {57, 3, 89, 4, 5, 60, 59, 58, 1, 0, 57}) {
    SteppedBody alone = make(0);
    alone.displacements_at(k, x);
    EXPECT_EQ(x, sequence[static_cast<std::size_t>(k)]) << "alone, frame " << k;
    few.displacements_at(k, x);
    EXPECT_EQ(x, sequence[static_cast<std::size_t>(k)]) << "few kept, frame " << k;
    all.displacements_at(k, x);
    EXPECT_EQ(x, sequence[static_cast<std::size_t>(k)]) << "all kept, frame " << k;
  }
}

TEST(ElasticBody, AMotionThatEndedCostsNothing) {
  SpringNet net = stiff_chain(3);
  net.damping = 200;
  SteppedBody body(net, EdgeRest::driven, chain_drive(3, 4), chain_time);
  Displacements x, later;
  body.displacements_at(900'000, x);  // 14 million steps, were they taken
  body.displacements_at(1'000'000, later);
  EXPECT_EQ(x, later);
}

// Followed for as long as it swings: a key that repeats the last value much later changes nothing before it.
TEST(ElasticBody, AWeightThatSwingsOnAndOnDrivesOnAndOn) {
  const auto driven_until = [](std::int64_t last_frame) {
    MorphDrive drive = chain_drive(3, 4);
    drive.weights.tracks[0].track = Track({Interpolation::step,
                                           1,
                                           false,
                                           chain_time.ticks_per_second(),
                                           {0, chain_time.frame_ticks(1), chain_time.frame_ticks(last_frame)},
                                           {0, 1, 1}})
                                        .on_spring({0.5, 0});
    return drive;
  };
  SpringNet net = stiff_chain(3);
  net.damping = 200;
  SteppedBody body(net, EdgeRest::driven, driven_until(2), chain_time);
  SteppedBody longer(net, EdgeRest::driven, driven_until(600), chain_time);
  Displacements x, expected, before;
  double largest_step = 0;
  for (std::int64_t frame = 300; frame < 400; ++frame) {
    body.displacements_at(frame, x);
    longer.displacements_at(frame, expected);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_NEAR(x[i].x, expected[i].x, 1e-9) << "frame " << frame << ", mass " << i;
      if (!before.empty()) largest_step = std::max(largest_step, std::abs(x[i].x - before[i].x));
    }
    before = x;
  }
  EXPECT_GT(largest_step, 1e-3) << "nothing swings";
}

TEST(ElasticBody, TheMethodFollowsFromTheNetAndItsKeys) {
  const auto method = [](const SpringNet& net, const MorphDrive& drive) {
    return make_elastic_body(net, EdgeRest::driven, drive, chain_time)->method();
  };
  EXPECT_EQ(method(stiff_chain(8), chain_drive(8, 3)), ElasticMethod::modal);
  const std::size_t many = max_modal_masses + 1;
  EXPECT_EQ(method(stiff_chain(many), chain_drive(many, 3)), ElasticMethod::tr_bdf2);
  MorphDrive on_spring = chain_drive(8, 3);
  on_spring.weights.tracks[0].track =
      Track({Interpolation::step, 1, false, chain_time.ticks_per_second(), {0, 1'000'000}, {0, 1}}).on_spring({5, 0.5});
  EXPECT_EQ(method(stiff_chain(8), on_spring), ElasticMethod::tr_bdf2);
  SpringNet huge;
  huge.masses = max_elastic_masses + 1;
  expect_error([&] { make_elastic_body(huge, EdgeRest::driven, {}, chain_time); }, ErrorKind::bad_input,
               "200001 different vertices; 200000 are possible");
}

TEST(ElasticBody, OverflowIsAnError) {
  MorphDrive drive = chain_drive(4, 3);
  for (Displacements& target : drive.targets)
    for (glm::dvec3& d : target) d *= 1e308;
  for (const bool modal : {true, false}) {
    const auto run = [&] {
      Displacements x;
      if (modal)
        ModalBody(stiff_chain(4), EdgeRest::driven, drive, chain_time).displacements_at(2, x);
      else
        SteppedBody(stiff_chain(4), EdgeRest::driven, drive, chain_time).displacements_at(2, x);
    };
    expect_error(run, ErrorKind::bad_input, "overflows");
  }
}

}  // namespace
}  // namespace morphcl
