// Frame buffers as device buffers that use the frames' own memory.
#pragma once

#include <map>
#include <vector>

#include "host/device/cl_error.hpp"
#include "host/image/raw_frame.hpp"
#include "host/render/frame/kernel_layout.hpp"

namespace morphcl {

struct DevicePicture {
  // Whole rows of tiles, from the top, that the device takes as one buffer; most pictures are one band.
  struct Band {
    cl::Buffer rows;
    layout::uint first_tile, tiles;
  };
  std::vector<Band> bands;
  RawFrame memory;
};

class DevicePictures {
 public:
  // No band gets more than `max_band` bytes, where one row of tiles fits that; see make_device_renderer().
  DevicePictures(cl::Context context, std::size_t max_band);

  // Nor more rows of tiles than `max_tile_rows`, which is at least 1.
  DevicePicture picture(FrameBuffer& frame, std::size_t max_tile_rows);

  // Waits for the queue and brings the frame to host memory on devices that keep their own copy; on a CPU that costs
  // next to nothing. What it gives back to the device is still queued then; it was only read, so nothing is copied.
  static void bring_to_host(const cl::CommandQueue& queue, const DevicePicture& picture);

 private:
  cl::Buffer wrap(void* memory, std::size_t bytes);

  cl::Context context_;
  std::size_t max_band_;
  std::map<std::pair<void*, std::size_t>, cl::Buffer> buffers_;
};

}  // namespace morphcl
