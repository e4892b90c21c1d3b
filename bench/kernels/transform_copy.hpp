// Copying, the least that a batch transform could do with its bytes; and work shared among threads.
#pragma once

#include <cstddef>
#include <functional>

namespace morphcl::bench {

// Runs work(first, count) for runs of [0, size) on `threads` threads, each run a multiple of 64 but for the last.
void on_threads(int threads, std::size_t size, const std::function<void(std::size_t, std::size_t)>& work);

// As std::memcpy.
void copy(const std::byte* from, std::byte* to, std::size_t bytes, int threads);

// With stores that bypass the cache, in the widest vectors the processor has. Both addresses are multiples of 64.
void copy_past_cache(const std::byte* from, std::byte* to, std::size_t bytes, int threads);

}  // namespace morphcl::bench
