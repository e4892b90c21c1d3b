#include "lab/accuracy/verdict.hpp"

#include <fmt/core.h>

#include <algorithm>

namespace morphcl::accuracy {

namespace {

// Of the first timing: the host's, or of a result of the device the device's.
double time_of(const Result& result) { return result.timings.empty() ? 0 : result.timings.front().minimum_ns; }

bool counts(const Result& result, const std::string& family, Measure measure) {
  const double error = result.figures[measure];
  return result.family == family && time_of(result) > 0 && error - error == 0 &&
         !(result.figures[Measure::not_finite] > 0);
}

std::string time_text(double nanoseconds) {
  if (nanoseconds < 1e3) return fmt::format("{:.3g} ns", nanoseconds);
  if (nanoseconds < 1e6) return fmt::format("{:.3g} us", nanoseconds / 1e3);
  return fmt::format("{:.3g} ms", nanoseconds / 1e6);
}

std::string described(const Result& result, Measure measure) {
  return fmt::format("{} ({}, {})", result.variant, printed(result.figures[measure]), time_text(time_of(result)));
}

}  // namespace

double Result::nanoseconds(const std::string& where) const {
  const auto found = std::find_if(timings.begin(), timings.end(), [&](const Timing& t) { return t.where == where; });
  return found == timings.end() ? 0 : found->minimum_ns;
}

std::vector<const Result*> pareto_front(const OperationReport& report, const std::string& family) {
  const Measure measure = report.about.plotted;
  std::vector<const Result*> sorted;
  for (const Result& result : report.results)
    if (counts(result, family, measure)) sorted.push_back(&result);
  std::stable_sort(sorted.begin(), sorted.end(), [&](const Result* a, const Result* b) {
    if (time_of(*a) != time_of(*b)) return time_of(*a) < time_of(*b);
    return a->figures[measure] < b->figures[measure];
  });
  std::vector<const Result*> front;
  for (const Result* result : sorted)
    if (front.empty() || result->figures[measure] < front.back()->figures[measure]) front.push_back(result);
  return front;
}

std::string verdict(const OperationReport& report, const std::string& family) {
  const Measure measure = report.about.plotted;
  const std::vector<const Result*> front = pareto_front(report, family);
  if (front.empty()) return "no variant gives finite results";
  const auto enough = std::find_if(front.begin(), front.end(), [&](const Result* result) {
    return result->figures[measure] <= report.about.target;
  });
  if (enough == front.end())
    return fmt::format("none is within the target; best is {}", described(*front.back(), measure));
  const std::string sentence = fmt::format("{} is enough", described(**enough, measure));
  if (enough + 1 == front.end()) return sentence + "; none is better";
  const Result& better = **(enough + 1);
  return fmt::format("{}; better: {}, {:.2g} times the time", sentence, described(better, measure),
                     time_of(better) / time_of(**enough));
}

}  // namespace morphcl::accuracy
