#include "host/render/device/device_picture.hpp"

#include <algorithm>

namespace morphcl {

namespace {

constexpr std::size_t max_buffers = 64;

}  // namespace

DevicePictures::DevicePictures(cl::Context context, std::size_t max_band)
    : context_(std::move(context)), max_band_(max_band) {}

DevicePicture DevicePictures::picture(FrameBuffer& frame, std::size_t max_tile_rows) {
  // Forgotten between frames only: one picture's bands are kept together, however many they are.
  if (buffers_.size() > max_buffers) buffers_.clear();
  DevicePicture picture{{}, RawFrame(frame)};
  const RawFrame& memory = picture.memory;
  const std::size_t tile_row_bytes = memory.row_bytes * FrameBuffer::tile_side;
  const auto tile_rows = static_cast<std::size_t>(frame.tiles_y()), columns = static_cast<std::size_t>(frame.tiles_x());
  const std::size_t rows_a_band =
      std::clamp<std::size_t>(std::min(max_band_ / tile_row_bytes, max_tile_rows), 1, tile_rows);
  for (std::size_t first = 0; first < tile_rows; first += rows_a_band) {
    const std::size_t rows = std::min(rows_a_band, tile_rows - first);
    picture.bands.push_back({wrap(memory.data + first * tile_row_bytes, rows * tile_row_bytes),
                             static_cast<layout::uint>(first * columns), static_cast<layout::uint>(rows * columns)});
  }
  return picture;
}

cl::Buffer DevicePictures::wrap(void* memory, std::size_t bytes) {
  cl::Buffer& buffer = buffers_[{memory, bytes}];
  if (!buffer())
    buffer = checked("wrapping a frame's memory",
                     [&] { return cl::Buffer(context_, CL_MEM_READ_WRITE | CL_MEM_USE_HOST_PTR, bytes, memory); });
  return buffer;
}

void DevicePictures::bring_to_host(const cl::CommandQueue& queue, const DevicePicture& picture) {
  checked("bringing the frame to the host", [&] {
    std::vector<std::pair<cl::Buffer, void*>> mapped;
    for (const DevicePicture::Band& band : picture.bands)
      mapped.emplace_back(
          band.rows, queue.enqueueMapBuffer(band.rows, CL_FALSE, CL_MAP_READ, 0, band.rows.getInfo<CL_MEM_SIZE>()));
    queue.finish();
    for (const auto& [buffer, pointer] : mapped) queue.enqueueUnmapMemObject(buffer, pointer);
  });
}

}  // namespace morphcl
