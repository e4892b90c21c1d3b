// Tables of the host's in one buffer of the device, one after the other, each brought there only when it changed.
#pragma once

#include <array>
#include <cstring>
#include <vector>

#include "host/device/device_buffer.hpp"

namespace morphcl {

template <class Meaning, std::size_t count>
class TableBuffer {
 public:
  explicit TableBuffer(cl::Context context) : buffer_(std::move(context)) {}

  // Makes room for tables of these sizes in bytes. Where one has to grow, all of them move and are lost: true.
  bool make_room(const std::array<std::size_t, count>& bytes) {
    bool fits = true;
    for (std::size_t i = 0; i < count; ++i) fits &= bytes[i] <= offsets_[i + 1] - offsets_[i];
    if (fits) return false;
    forget();
    constexpr std::size_t line = 64;
    std::array<std::size_t, count + 1> offsets{};
    for (std::size_t i = 0; i < count; ++i) offsets[i + 1] = offsets[i] + (bytes[i] + line - 1) / line * line;
    buffer_.ensure_bytes(offsets[count]);  // where that fails, the old room is still there
    offsets_ = offsets;
    return true;
  }

  // In words of 4 bytes, as kernels count.
  std::uint32_t offset(std::size_t table) const { return static_cast<std::uint32_t>(offsets_[table] / 4); }

  // Queues the upload of a table if it differs from what was uploaded last. Nothing is waited for: all that was queued
  // has to have finished before the table's next update.
  template <class T>
  void update(const cl::CommandQueue& queue, std::size_t table, const T* values, std::size_t size) {
    static_assert(std::is_trivially_copyable_v<T>);
    std::vector<char>& uploaded = uploaded_[table];
    const std::size_t bytes = size * sizeof(T);
    if (valid_[table] && bytes == uploaded.size() && (bytes == 0 || std::memcmp(values, uploaded.data(), bytes) == 0))
      return;
    valid_[table] = false;
    const char* first = reinterpret_cast<const char*>(values);
    uploaded.assign(first, first + bytes);
    checked("uploading a frame's tables", [&] {
      if (bytes > 0) queue.enqueueWriteBuffer(buffer_.buffer(), CL_FALSE, offsets_[table], bytes, uploaded.data());
    });
    valid_[table] = true;
  }
  template <class T>
  void update(const cl::CommandQueue& queue, std::size_t table, const std::vector<T>& values) {
    update(queue, table, values.data(), values.size());
  }

  void forget() { valid_ = {}; }
  const DeviceBuffer<Meaning>& buffer() const { return buffer_; }

 private:
  DeviceBuffer<Meaning> buffer_;
  std::array<std::size_t, count + 1> offsets_{};  // of each table, and their end
  std::array<std::vector<char>, count> uploaded_;
  std::array<bool, count> valid_{};
};

}  // namespace morphcl
