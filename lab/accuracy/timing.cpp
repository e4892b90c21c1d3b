#include "lab/accuracy/timing.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <vector>

namespace morphcl::accuracy {

namespace {

double nanoseconds_of(const std::function<void()>& run, int calls) {
  const auto start = std::chrono::steady_clock::now();
  for (int call = 0; call < calls; ++call) run();
  return std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - start).count();
}

// At most eight calls: a machine that is busy never takes equally long.
double warm_up(const std::function<void()>& run) {
  double before = nanoseconds_of(run, 1);
  for (int call = 1; call < 8; ++call) {
    const double now = nanoseconds_of(run, 1);
    if (std::abs(now - before) < 0.1 * now) return now;
    before = now;
  }
  return before;
}

}  // namespace

Timing time_batch(const std::function<void()>& run, std::size_t elements, const TimingPlan& plan) {
  const double once = std::max(warm_up(run), 1.0);
  const int calls = static_cast<int>(std::clamp(std::ceil(plan.shortest_run_ns / once), 1.0, 1e6));
  std::vector<double> times;
  for (int i = 0; i < plan.runs; ++i)
    times.push_back(nanoseconds_of(run, calls) / calls / static_cast<double>(elements));
  std::sort(times.begin(), times.end());
  return {.where = "host",
          .level = "",
          .elements = elements,
          .runs = plan.runs,
          .minimum_ns = times.front(),
          .median_ns = times[times.size() / 2]};
}

}  // namespace morphcl::accuracy
