// Memory that the host and the device both use: zero-copy on a CPU device, copied by the driver at map and unmap
// elsewhere.
#pragma once

#include <cstddef>
#include <span>
#include <type_traits>

#include "host/device/cl_error.hpp"

namespace morphcl {

// Access for the host while it lives; the device must not use the buffer meanwhile. Unmapped at the end.
template <class T>
class Mapped {
 public:
  Mapped(const cl::CommandQueue& queue, const cl::Buffer& buffer, std::size_t count)
      : queue_(queue), buffer_(buffer), count_(count) {
    constexpr cl_map_flags flags = std::is_const_v<T> ? CL_MAP_READ : CL_MAP_READ | CL_MAP_WRITE;
    checked("mapping a buffer",
            [&] { data_ = static_cast<T*>(queue_.enqueueMapBuffer(buffer_, CL_TRUE, flags, 0, count * sizeof(T))); });
  }
  ~Mapped() {
    // A destructor cannot report; a device lost here fails the next call as well.
    try {
      queue_.enqueueUnmapMemObject(buffer_, const_cast<std::remove_const_t<T>*>(data_));
    } catch (const cl::Error&) {
    }
  }
  Mapped(const Mapped&) = delete;
  Mapped& operator=(const Mapped&) = delete;

  std::span<T> span() const { return {data_, count_}; }
  T* data() const { return data_; }
  std::size_t size() const { return count_; }
  T& operator[](std::size_t index) const { return data_[index]; }

 private:
  cl::CommandQueue queue_;
  cl::Buffer buffer_;
  T* data_ = nullptr;
  std::size_t count_;
};

// A buffer that grows and keeps its memory from frame to frame. Its host memory is page-aligned, on huge pages from
// 4 MiB up, and lives until the last command that uses the buffer has finished.
class SharedBuffer {
 public:
  explicit SharedBuffer(cl::Context context, cl_mem_flags access = CL_MEM_READ_WRITE);

  // Makes the buffer hold at least `bytes`. When it must grow the content is lost and buffer() is another object.
  // Error(no_device) if the device or the host has not got that much.
  void ensure(std::size_t bytes);

  const cl::Buffer& buffer() const { return buffer_; }  // at least one page, unless ensure() has thrown
  std::size_t capacity() const { return capacity_; }    // bytes

  // The first `count` elements, after everything in the queue has run. Mapped<const T> leaves the content to the
  // device.
  template <class T>
  Mapped<T> map(const cl::CommandQueue& queue, std::size_t count) const {
    return Mapped<T>(queue, buffer_, count);
  }

 private:
  cl::Context context_;
  cl_mem_flags access_;
  cl::Buffer buffer_;
  std::size_t capacity_ = 0;
};

}  // namespace morphcl
