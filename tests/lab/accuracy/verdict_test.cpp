// Pareto fronts and sentences on results that are made up.
#include "lab/accuracy/verdict.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace morphcl::accuracy {
namespace {

Result made_up(const std::string& variant, double nanoseconds, double error, double not_finite = 0) {
  Result result;
  result.family = "benign";
  result.variant = variant;
  result.place = "host";
  result.figures[Measure::max_ulp] = error;
  result.figures[Measure::not_finite] = not_finite;
  Timing timing;
  timing.where = "host";
  timing.minimum_ns = timing.median_ns = nanoseconds;
  result.timings.push_back(timing);
  return result;
}

OperationReport with(std::vector<Result> results, double target) {
  OperationReport report;
  report.about.plotted = Measure::max_ulp;
  report.about.target = target;
  report.families = {{"benign", ""}};
  report.results = std::move(results);
  return report;
}

std::vector<std::string> front_of(const OperationReport& report) {
  std::vector<std::string> names;
  for (const Result* result : pareto_front(report, "benign")) names.push_back(result->variant);
  return names;
}

TEST(ParetoFront, HoldsWhatNothingBeats) {
  const OperationReport report = with(
      {made_up("slow and good", 10, 0.5), made_up("beaten", 5, 5), made_up("middle", 4, 2), made_up("fast", 1, 9)}, 1);
  EXPECT_EQ(front_of(report), (std::vector<std::string>{"fast", "middle", "slow and good"}));
}

TEST(ParetoFront, OfEqualErrorsTheFasterOneCounts) {
  EXPECT_EQ(front_of(with({made_up("a", 2, 1), made_up("b", 1, 1)}, 1)), (std::vector<std::string>{"b"}));
}

TEST(ParetoFront, LeavesOutWhatIsNotFinite) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  EXPECT_EQ(front_of(with(
                {made_up("nan", 1, nan), made_up("inf", 1, inf), made_up("some", 1, 0, 3), made_up("good", 9, 1)}, 1)),
            (std::vector<std::string>{"good"}));
}

TEST(Verdict, NamesTheCheapestWithinTheTargetAndTheNextBetter) {
  const OperationReport report = with({made_up("good", 8, 0.5), made_up("fine", 2, 1), made_up("bad", 1, 9)}, 1);
  EXPECT_EQ(verdict(report, "benign"), "fine (1, 2 ns) is enough; better: good (0.5, 8 ns), 4 times the time");
}

TEST(Verdict, SaysWhenNothingIsBetterOrEnough) {
  EXPECT_EQ(verdict(with({made_up("only", 2e3, 1)}, 1), "benign"), "only (1, 2 us) is enough; none is better");
  EXPECT_EQ(verdict(with({made_up("only", 2e6, 3)}, 1), "benign"), "none is within the target; best is only (3, 2 ms)");
  EXPECT_EQ(verdict(with({}, 1), "benign"), "no variant gives finite results");
}

}  // namespace
}  // namespace morphcl::accuracy
