#include "morphcl/frame.hpp"

#include <fmt/format.h>
#include <sys/mman.h>

#include <algorithm>

#include "host/image/raw_frame.hpp"
#include "morphcl/error.hpp"

namespace morphcl {

namespace {

constexpr std::size_t page_bytes = 4096;
constexpr std::size_t huge_page_bytes = std::size_t{2} << 20;

std::size_t round_up(std::size_t n, std::size_t multiple) { return (n + multiple - 1) / multiple * multiple; }

void* map(std::size_t bytes) {
  void* memory = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (memory == MAP_FAILED)
    throw Error(ErrorKind::internal, "", fmt::format("not enough memory for {} bytes of an image", bytes));
  return memory;
}

// First touch of a frame costs more than drawing it where the kernel hands out 4 KB at a time.
char* map_huge(std::size_t bytes) {
  char* memory = static_cast<char*>(map(bytes + huge_page_bytes));
  const std::size_t skip = huge_page_bytes - reinterpret_cast<std::uintptr_t>(memory) % huge_page_bytes;
  munmap(memory, skip);
  if (skip < huge_page_bytes) munmap(memory + skip + bytes, huge_page_bytes - skip);
  madvise(memory + skip, bytes, MADV_HUGEPAGE);  // a wish: refused, everything works, only slower
  return memory + skip;
}

}  // namespace

void FrameBuffer::Unmap::operator()(void* memory) const { munmap(memory, bytes); }

std::unique_ptr<std::byte[], FrameBuffer::Unmap> FrameBuffer::map_memory(std::size_t bytes) {
  const std::size_t mapped = round_up(bytes, page_bytes);
  void* memory = mapped >= huge_page_bytes ? map_huge(mapped) : map(mapped);
  return std::unique_ptr<std::byte[], Unmap>(static_cast<std::byte*>(memory), Unmap{mapped});
}

FrameBuffer::FrameBuffer(int width, int height, ChannelSet channels)
    : width_(width), height_(height), channels_(channels) {
  if (width < 1 || height < 1 || width > max_side || height > max_side)
    throw Error(ErrorKind::bad_input, "",
                fmt::format("an image of {} x {} pixels; 1 to {} a side are possible", width, height, max_side));
  const auto tiles = [](int pixels) { return static_cast<int>((pixels + tile_side - 1) / tile_side); };
  tiles_x_ = tiles(width);
  tiles_y_ = tiles(height);
  constexpr std::size_t cache_line = 64;
  for (const Channel channel : channels) {
    offsets_[static_cast<std::size_t>(channel)] = notes_offset_;
    notes_offset_ += padded_width() * pixel_bytes(channel);
  }
  row_bytes_ = notes_offset_ + round_up(static_cast<std::size_t>(tiles_x_) * sizeof(std::uint32_t), cache_line);
  memory_ = map_memory(bytes());
}

RawFrame::RawFrame(FrameBuffer& frame)
    : data(frame.memory_.get()),
      row_bytes(frame.row_bytes_),
      bytes(frame.bytes()),
      notes_offset(frame.notes_offset_),
      channels(frame.channels_),
      padded_width(frame.padded_width()),
      offsets(frame.offsets_),
      notes_hold(frame.any_blank_) {
  frame.any_blank_ = true;
  // A renderer that fails before it has drawn leaves notes that are true: nothing is known to be blank.
  if (!notes_hold)
    for (int tile_y = 0; tile_y < frame.tiles_y_; ++tile_y) std::fill_n(&note(0, tile_y), frame.tiles_x_, 0u);
}

}  // namespace morphcl
