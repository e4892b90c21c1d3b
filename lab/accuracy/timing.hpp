// How long a batch takes: warm, at least 30 runs, minimum and median.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace morphcl::accuracy {

struct Timing {
  std::string where;  // "host", "device" (the kernel alone) or "device+transfer"
  std::string level;  // where inputs and results of the batch fit: "L1", "L2", "memory"
  std::size_t elements = 0;
  int runs = 0;
  double minimum_ns = 0, median_ns = 0;  // per element
};

struct TimingPlan {
  int runs = 30;
  double shortest_run_ns = 20'000;  // calls are repeated within a run until it is as long
};

// Times `run`, which works through `elements` elements, after calling it until two calls in a row took about as long.
Timing time_batch(const std::function<void()>& run, std::size_t elements, const TimingPlan& plan);

}  // namespace morphcl::accuracy
