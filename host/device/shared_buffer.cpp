#include "host/device/shared_buffer.hpp"

#include <fmt/format.h>
#include <sys/mman.h>

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <string_view>
#include <utility>

namespace morphcl {

namespace {

constexpr std::size_t page_bytes = 4096;
constexpr std::size_t huge_page_bytes = std::size_t{2} << 20;
constexpr std::size_t huge_page_threshold = 2 * huge_page_bytes;

struct Free {
  void operator()(void* memory) const { std::free(memory); }
};
using HostMemory = std::unique_ptr<void, Free>;

void CL_CALLBACK free_host_memory(cl_mem, void* memory) { std::free(memory); }

std::size_t granularity(std::size_t bytes) { return bytes >= huge_page_threshold ? huge_page_bytes : page_bytes; }

std::size_t round_up(std::size_t bytes) {
  const std::size_t step = granularity(bytes);
  return bytes == 0 ? step : (bytes + step - 1) / step * step;
}

std::size_t max_allocation(const cl::Context& context) {
  return context.getInfo<CL_CONTEXT_DEVICES>().front().getInfo<CL_DEVICE_MAX_MEM_ALLOC_SIZE>();
}

HostMemory allocate(std::size_t bytes) {
  HostMemory memory(std::aligned_alloc(granularity(bytes), bytes));
  if (memory && bytes >= huge_page_threshold) madvise(memory.get(), bytes, MADV_HUGEPAGE);
  return memory;
}

Error too_large(std::size_t bytes, std::string_view limit) {
  return Error(
      ErrorKind::no_device, "",
      fmt::format("a buffer of {} bytes is needed, but {}; a smaller picture or scene, or another device would do",
                  bytes, limit));
}

}  // namespace

SharedBuffer::SharedBuffer(cl::Context context, cl_mem_flags access) : context_(std::move(context)), access_(access) {
  ensure(1);
}

void SharedBuffer::ensure(std::size_t bytes) {
  if (bytes <= capacity_) return;
  checked("growing a buffer", [&] {
    const std::size_t max_bytes = max_allocation(context_);
    if (bytes > max_bytes) throw too_large(bytes, fmt::format("the device's largest allocation is {}", max_bytes));
    const std::size_t allocated = round_up(bytes);
    // Given back before the new memory is taken, so that both never stand side by side.
    buffer_ = cl::Buffer();
    capacity_ = 0;
    HostMemory memory = allocate(allocated);
    if (!memory) throw too_large(bytes, "this machine has no memory left");
    const std::size_t capacity = std::min(allocated, max_bytes);
    cl::Buffer buffer(context_, access_ | CL_MEM_USE_HOST_PTR, capacity, memory.get());
    buffer.setDestructorCallback(free_host_memory, memory.get());
    memory.release();
    buffer_ = std::move(buffer);
    capacity_ = capacity;
  });
}

}  // namespace morphcl
