#include "host/render/device/frame_planes.hpp"

namespace morphcl {

FramePlanes FramePlaneCache::planes(FrameBuffer& frame) {
  const FrameBuffer::Planes memory = frame.planes();
  FramePlanes planes;
  planes.notes_hold = memory.notes_hold;
  planes.blank_blocks = wrap(memory.blank_blocks, memory.tiles * sizeof(std::uint32_t));
  for (int channel = 0; channel < 4; ++channel)
    planes.color[channel] = frame.has_color()
                                ? wrap(memory.color[channel], frame.plane_elements() * sizeof(std::uint16_t))
                                : planes.blank_blocks;
  planes.depth = frame.has_depth() ? wrap(memory.depth, frame.plane_elements() * sizeof(float)) : planes.blank_blocks;
  return planes;
}

cl::Buffer FramePlaneCache::wrap(void* plane, std::size_t bytes) {
  constexpr std::size_t most_planes = 64;
  if (buffers_.size() > most_planes) buffers_.clear();
  cl::Buffer& buffer = buffers_[{plane, bytes}];
  if (!buffer())
    buffer = checked("wrapping a frame's plane",
                     [&] { return cl::Buffer(context_, CL_MEM_READ_WRITE | CL_MEM_USE_HOST_PTR, bytes, plane); });
  return buffer;
}

void FramePlaneCache::bring_to_host(const cl::CommandQueue& queue, const FramePlanes& planes) {
  checked("bringing the frame to the host", [&] {
    std::vector<std::pair<cl::Buffer, void*>> mapped;
    const auto map = [&](const cl::Buffer& plane) {
      mapped.emplace_back(plane, queue.enqueueMapBuffer(plane, CL_FALSE, CL_MAP_READ, 0, plane.getInfo<CL_MEM_SIZE>()));
    };
    map(planes.blank_blocks);
    if (planes.depth() != planes.blank_blocks()) map(planes.depth);
    if (planes.color[0]() != planes.blank_blocks())
      for (const cl::Buffer& plane : planes.color) map(plane);
    queue.finish();
    for (const auto& [plane, pointer] : mapped) queue.enqueueUnmapMemObject(plane, pointer);
  });
}

}  // namespace morphcl
