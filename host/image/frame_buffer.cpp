#include "host/image/frame_buffer.hpp"

#include <fmt/format.h>
#include <sys/mman.h>

#include <algorithm>

#include "host/error.hpp"

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

// First touch of a plane costs more than drawing it where the kernel hands out 4 KB at a time.
char* map_huge(std::size_t bytes) {
  char* memory = static_cast<char*>(map(bytes + huge_page_bytes));
  const std::size_t skip = huge_page_bytes - reinterpret_cast<std::uintptr_t>(memory) % huge_page_bytes;
  munmap(memory, skip);
  if (skip < huge_page_bytes) munmap(memory + skip + bytes, huge_page_bytes - skip);
  madvise(memory + skip, bytes, MADV_HUGEPAGE);  // a wish: refused, everything works, only slower
  return memory + skip;
}

}  // namespace

void FrameBuffer::Unmap::operator()(void* plane) const { munmap(plane, bytes); }

template <class T>
std::unique_ptr<T[], FrameBuffer::Unmap> FrameBuffer::map_plane(std::size_t elements) {
  const std::size_t bytes = round_up(elements * sizeof(T), page_bytes);
  void* plane = bytes >= huge_page_bytes ? map_huge(bytes) : map(bytes);
  return std::unique_ptr<T[], Unmap>(static_cast<T*>(plane), Unmap{bytes});
}

FrameBuffer::FrameBuffer(int width, int height, bool color, bool depth) : width_(width), height_(height) {
  if (width < 1 || height < 1 || width > max_side || height > max_side)
    throw Error(ErrorKind::bad_input, "",
                fmt::format("an image of {} x {} pixels; 1 to {} a side are possible", width, height, max_side));
  row_pitch_ = round_up(static_cast<std::size_t>(width), tile_side);
  padded_rows_ = round_up(static_cast<std::size_t>(height), tile_side);
  if (color)
    for (auto& plane : color_) plane = map_plane<std::uint16_t>(plane_elements());
  if (depth) depth_ = map_plane<float>(plane_elements());
  blank_blocks_ = map_plane<std::uint32_t>(static_cast<std::size_t>(tiles_x()) * tiles_y());
}

FrameBuffer::Planes FrameBuffer::planes() {
  const bool notes_hold = any_blank_;
  const std::size_t tiles = static_cast<std::size_t>(tiles_x()) * tiles_y();
  // A renderer that fails before it has drawn leaves notes that are true: nothing is known to be blank.
  if (!notes_hold) std::fill_n(blank_blocks_.get(), tiles, 0u);
  any_blank_ = true;
  return {{color_[0].get(), color_[1].get(), color_[2].get(), color_[3].get()},
          depth_.get(),
          blank_blocks_.get(),
          tiles,
          notes_hold};
}

}  // namespace morphcl
