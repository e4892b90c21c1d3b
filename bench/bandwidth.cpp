// morphcl_bench_bandwidth [THREADS]: how fast this machine's threads fill, read and copy memory, in 10^9 bytes a second
// of all threads together, as one line of JSON. What a stage moves at least, by these, is what it could take at best.
//
// Arrays are far larger than any cache and written past it. Best of five runs.

#include <fmt/format.h>
#ifdef __x86_64__
#include <emmintrin.h>
#endif

#include <algorithm>
#include <barrier>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <numeric>
#include <thread>
#include <vector>

namespace {

using Clock = std::chrono::steady_clock;
constexpr std::size_t words_per_thread = std::size_t{32} << 20;  // 256 MiB
constexpr int runs = 5;

struct Arrays {
  std::vector<std::uint64_t> from, to;
  std::uint64_t sum = 0;
};

void fill_past_cache(std::vector<std::uint64_t>& words) {
#ifdef __x86_64__
  for (std::uint64_t& word : words) _mm_stream_si64(reinterpret_cast<long long*>(&word), 3);
  _mm_sfence();
#else
  std::memset(words.data(), 3, words.size() * sizeof(words[0]));
#endif
}

// GB/s of `work`, which moves `bytes` and runs on every thread at the same time with arrays of its own: from when the
// first one begins to when the last one ends. The threads take the times, as the one that waits may have to wait
// longer.
double best_rate(std::vector<Arrays>& arrays, double bytes, const std::function<void(Arrays&)>& work) {
  double best = 0.0;
  for (int run = 0; run < runs; ++run) {
    std::vector<Clock::time_point> begins(arrays.size()), ends(arrays.size());
    std::barrier start(static_cast<std::ptrdiff_t>(arrays.size()));
    {
      std::vector<std::jthread> threads;
      for (std::size_t i = 0; i < arrays.size(); ++i)
        threads.emplace_back([&, i] {
          start.arrive_and_wait();
          begins[i] = Clock::now();
          work(arrays[i]);
          ends[i] = Clock::now();
        });
    }
    const Clock::duration took = *std::ranges::max_element(ends) - *std::ranges::min_element(begins);
    best =
        std::max(best, bytes * static_cast<double>(arrays.size()) / std::chrono::duration<double>(took).count() / 1e9);
  }
  return best;
}

}  // namespace

int main(int argc, char** argv) {
  const int wanted = argc > 1 ? std::atoi(argv[1]) : static_cast<int>(std::thread::hardware_concurrency());
  if (argc > 2 || wanted < 1 || wanted > 256) {
    fmt::print(stderr, "usage: morphcl_bench_bandwidth [THREADS], 1 to 256\n");
    return 2;
  }
  std::vector<Arrays> arrays(static_cast<std::size_t>(wanted));
  for (Arrays& each : arrays) {
    each.from.assign(words_per_thread, 1);
    each.to.assign(words_per_thread, 2);
  }

  const double bytes = words_per_thread * sizeof(std::uint64_t);
  const double fill = best_rate(arrays, bytes, [](Arrays& own) { fill_past_cache(own.to); });
  const double read = best_rate(arrays, bytes, [](Arrays& own) {
    own.sum += std::accumulate(own.from.begin(), own.from.end(), std::uint64_t{0});
  });
  const double copy = best_rate(arrays, 2.0 * bytes, [&](Arrays& own) {
    std::memcpy(own.to.data(), own.from.data(), words_per_thread * sizeof(own.to[0]));
  });
  for (const Arrays& each : arrays)
    if (each.sum != runs * words_per_thread || each.to.back() != 1) return 70;
  fmt::print("{{\"threads\": {}, \"fill\": {}, \"read\": {}, \"copy\": {}}}\n", wanted, fill, read, copy);
  return 0;
}
