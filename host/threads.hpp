// Threads where the system may start fewer than are wanted.
#pragma once

#include <system_error>
#include <thread>
#include <vector>

namespace morphcl {

// Adds threads that run work(0), work(1) and so on, up to `wanted` of them, and stops at the first that the system does
// not start. Returns how many there are. `work` is copied.
template <class Work>
int start_threads(std::vector<std::jthread>& threads, int wanted, const Work& work) {
  threads.reserve(static_cast<std::size_t>(wanted));
  int started = 0;
  try {
    for (; started < wanted; ++started) threads.emplace_back(work, started);
  } catch (const std::system_error&) {
    // Those that run do the work of the others.
  }
  return started;
}

}  // namespace morphcl
