#include "host/thread_count.hpp"

#include <fmt/format.h>
#include <sched.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <memory>
#include <optional>
#include <string_view>
#include <thread>

#include "morphcl/error.hpp"

namespace morphcl {

namespace {

std::optional<int> slurm_cpus_per_task() {
  const char* value = std::getenv("SLURM_CPUS_PER_TASK");
  if (!value) return std::nullopt;
  const std::string_view text = value;
  int count = 0;
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), count);
  if (failure != std::errc() || end != text.data() + text.size() || count < 1 || count > max_threads)
    return std::nullopt;
  return count;
}

int affinity_count() {
  // The kernel refuses a mask smaller than its own, and does not say how large that is.
  for (int processors = 1024; processors <= (1 << 20); processors *= 4) {
    const std::size_t bytes = CPU_ALLOC_SIZE(processors);
    const auto free_mask = [](cpu_set_t* mask) { CPU_FREE(mask); };
    const std::unique_ptr<cpu_set_t, decltype(free_mask)> mask(CPU_ALLOC(processors), free_mask);
    if (mask && sched_getaffinity(0, bytes, mask.get()) == 0) return std::max(1, CPU_COUNT_S(bytes, mask.get()));
  }
  return static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
}

}  // namespace

int choose_thread_count(int requested) {
  if (requested < 0 || requested > max_threads)
    throw Error(ErrorKind::usage, "",
                fmt::format("{} threads asked for; 1 to {} are possible, 0 takes what the process may use", requested,
                            max_threads));
  if (requested > 0) return requested;
  return std::min(slurm_cpus_per_task().value_or(affinity_count()), max_threads);
}

}  // namespace morphcl
