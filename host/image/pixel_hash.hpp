// The pixel hash: two images have the same one exactly when their channels, window and every bit of their pixels are
// the same, whatever the compression of the file they came from.
//
// It is xxh3-128, seed 0, written as 32 hex digits of the canonical (big-endian) form, over the planes in
// the order of their plain names (channel_planes.hpp), each as: the name and a zero byte; the pixel type (0 uint, 1
// half, 2 float) and the data window (first x, first y, last x, last y), five 32-bit integers; the values, row by row
// from the top. All numbers are little-endian.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "morphcl/frame.hpp"

namespace morphcl {

class PixelHasher {
 public:
  struct Window {
    std::int32_t first_x = 0, first_y = 0, last_x = 0, last_y = 0;
  };

  PixelHasher();
  ~PixelHasher();
  void begin_channel(std::string_view name, PixelType type, const Window& window);
  void add_row(const void* values, std::size_t bytes);
  std::string hex() const;  // of all that was added so far

 private:
  struct State;
  std::unique_ptr<State> state_;
};

// Of a frame whose data window starts at (0, 0).
std::string pixel_hash(const FrameBuffer& frame);

// xxh3-128 of a text in the same 32 hex digits.
std::string text_hash(std::string_view text);

}  // namespace morphcl
