// The planes of frame buffers as device buffers that use the frames' own memory.
#pragma once

#include <map>
#include <vector>

#include "host/device/cl_error.hpp"
#include "host/image/frame_buffer.hpp"

namespace morphcl {

struct FramePlanes {
  cl::Buffer color[4], depth;  // where the frame has none: its blank_blocks, for kernels want some buffer
  cl::Buffer blank_blocks;
  bool notes_hold;  // see FrameBuffer::Planes
};

class FramePlaneCache {
 public:
  explicit FramePlaneCache(cl::Context context) : context_(std::move(context)) {}

  FramePlanes planes(FrameBuffer& frame);

  // Waits for the queue and brings the frame to host memory on devices that keep their own copy; on a CPU that costs
  // next to nothing. What it gives back to the device is still queued then; it was only read, so nothing is copied.
  static void bring_to_host(const cl::CommandQueue& queue, const FramePlanes& planes);

 private:
  cl::Buffer wrap(void* plane, std::size_t bytes);

  cl::Context context_;
  std::map<std::pair<void*, std::size_t>, cl::Buffer> buffers_;
};

}  // namespace morphcl
