#include "bench/kernels/transform_copy.hpp"

#include <algorithm>
#include <cstring>
#include <thread>
#include <vector>

#if defined(__AVX__)
#include <immintrin.h>
#endif

namespace morphcl::bench {

namespace {

void stream(const std::byte* from, std::byte* to, std::size_t bytes) {
  std::size_t at = 0;
#if defined(__AVX512F__)
  for (; at + 64 <= bytes; at += 64)
    _mm512_stream_si512(reinterpret_cast<__m512i*>(to + at), _mm512_loadu_si512(from + at));
#elif defined(__AVX__)
  for (; at + 32 <= bytes; at += 32)
    _mm256_stream_si256(reinterpret_cast<__m256i*>(to + at),
                        _mm256_loadu_si256(reinterpret_cast<const __m256i*>(from + at)));
#endif
  std::memcpy(to + at, from + at, bytes - at);
}

}  // namespace

void on_threads(int threads, std::size_t size, const std::function<void(std::size_t, std::size_t)>& work) {
  const std::size_t run = (size / static_cast<std::size_t>(threads) + 63) / 64 * 64;
  std::vector<std::jthread> others;
  for (std::size_t first = run; first < size; first += run)
    others.emplace_back([&, first] { work(first, std::min(run, size - first)); });
  work(0, std::min(run, size));
}

void copy(const std::byte* from, std::byte* to, std::size_t bytes, int threads) {
  on_threads(threads, bytes,
             [&](std::size_t first, std::size_t count) { std::memcpy(to + first, from + first, count); });
}

void copy_past_cache(const std::byte* from, std::byte* to, std::size_t bytes, int threads) {
  on_threads(threads, bytes, [&](std::size_t first, std::size_t count) { stream(from + first, to + first, count); });
}

}  // namespace morphcl::bench
