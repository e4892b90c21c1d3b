// A table of the host's in device memory, brought there only when it changed.
#pragma once

#include <algorithm>
#include <cstring>
#include <vector>

#include "host/device/shared_buffer.hpp"

namespace morphcl {

template <class T>
class DeviceTable {
 public:
  explicit DeviceTable(cl::Context context) : buffer_(std::move(context)) {}

  // Queues the upload of `values` if they differ from those uploaded last, and says so. Nothing is waited for: all that
  // was queued has to have finished before the next update.
  bool update(const cl::CommandQueue& queue, const T* values, std::size_t count) {
    static_assert(std::is_trivially_copyable_v<T>);
    if (valid_ && count == uploaded_.size() &&
        (count == 0 || std::memcmp(values, uploaded_.data(), count * sizeof(T)) == 0))
      return false;
    valid_ = false;
    uploaded_.assign(values, values + count);
    buffer_.ensure(std::max<std::size_t>(count, 1) * sizeof(T));
    checked("uploading a frame's tables", [&] {
      if (count > 0) queue.enqueueWriteBuffer(buffer_.buffer(), CL_FALSE, 0, count * sizeof(T), uploaded_.data());
    });
    valid_ = true;
    return true;
  }
  bool update(const cl::CommandQueue& queue, const std::vector<T>& values) {
    return update(queue, values.data(), values.size());
  }

  const cl::Buffer& buffer() const { return buffer_.buffer(); }

 private:
  SharedBuffer buffer_;
  std::vector<T> uploaded_;
  bool valid_ = false;
};

}  // namespace morphcl
