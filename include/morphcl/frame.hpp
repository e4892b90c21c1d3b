// A rendered frame in memory, its pixel hash, and its colours as plain arrays for whoever goes on with them elsewhere.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#pragma GCC visibility push(default)
namespace morphcl {

constexpr float background_depth = 1e10f;  // Z where nothing is drawn

// A frame: half R, G, B, A and float Z, row after row from the top.
//
// One piece of memory holds the whole frame. A row of the picture is a row of each channel, one after the other, as in
// a scan line of an EXR file: R, G, B, A, then Z, of which those that were not asked for are left out. The next row
// starts row_bytes() further on. What lies in a row behind a channel's width() elements is padding without meaning, as
// are rows below the picture: both are rounded up to whole tiles (64 pixels). Every row of every channel starts on a
// cache line (64 bytes), and the frame on a page, so that OpenCL can use it in place. Every element is 0 until it is
// written, and memory is only taken where something was written.
//
// The frame knows which of its tiles are blank (background everywhere), so that a renderer need not write them again
// and an encoder need not look at them.
class FrameBuffer {
 public:
  static constexpr std::size_t tile_side = 64, block_side = 16;  // pixels

  // Pixels a side. A channel of the largest frame holds 2^30 elements.
  static constexpr int max_side = 32768;

  // Error(bad_input) for a side outside 1..max_side, Error(internal) when the memory cannot be had.
  FrameBuffer(int width, int height, bool color, bool depth);

  int width() const { return width_; }
  int height() const { return height_; }
  bool has_color() const { return has_color_; }
  bool has_depth() const { return has_depth_; }

  // The width() pixels of row y (0..height() - 1, 0 at the top) in one channel: 0 R, 1 G, 2 B, 3 A; the bits of IEEE
  // binary16, linear light. Colour is premultiplied by alpha. Empty when the frame has no colour. A frame that
  // is not const forgets here which of its tiles are blank, as the caller may write.
  std::span<std::uint16_t> color_row(int channel, int y) {
    forget_blank_tiles();
    return row<std::uint16_t>(has_color_, y, color_offset(channel));
  }
  std::span<const std::uint16_t> color_row(int channel, int y) const {
    return row<std::uint16_t>(has_color_, y, color_offset(channel));
  }
  // The same of the positive distance along the view axis; background_depth where nothing is drawn, infinity where a
  // depth buffer other than the default holds a far plane at infinity.
  std::span<float> depth_row(int y) {
    forget_blank_tiles();
    return row<float>(has_depth_, y, depth_offset());
  }
  std::span<const float> depth_row(int y) const { return row<float>(has_depth_, y, depth_offset()); }

  // The memory itself: pixel (x, y) of a channel is at byte y * row_bytes() + its offset + x * its element's size.
  // bytes() counts the padding, of rows below the picture too.
  std::byte* data() {
    forget_blank_tiles();
    return memory_.get();
  }
  const std::byte* data() const { return memory_.get(); }
  std::size_t row_bytes() const { return row_bytes_; }
  std::size_t bytes() const { return row_bytes_ * padded_rows(); }
  std::size_t color_offset(int channel) const {
    return static_cast<std::size_t>(channel) * padded_width() * sizeof(std::uint16_t);
  }
  std::size_t depth_offset() const { return has_color_ ? color_offset(4) : 0; }

  // Tiles of 64 x 64 pixels, from (0, 0) at the upper left. blank(...): known to hold 0 in every colour channel and the
  // background's depth.
  int tiles_x() const { return tiles_x_; }
  int tiles_y() const { return tiles_y_; }
  bool blank(int tile_x, int tile_y) const { return any_blank_ && note(tile_x, tile_y) == all_blocks; }

  // The same of a block of 16 x 16 pixels.
  bool blank_block(int block_x, int block_y) const {
    constexpr int side = tile_side / block_side;
    const int bit = block_y % side * side + block_x % side;
    return any_blank_ && (note(block_x / side, block_y / side) >> bit & 1u) != 0;
  }

 private:
  friend struct RawFrame;
  static constexpr std::uint32_t all_blocks = 0xffff;  // of a tile: 4 x 4
  void forget_blank_tiles() { any_blank_ = false; }
  std::size_t padded_width() const { return static_cast<std::size_t>(tiles_x_) * tile_side; }
  std::size_t padded_rows() const { return static_cast<std::size_t>(tiles_y_) * tile_side; }
  template <class T>
  std::span<T> row(bool exists, int y, std::size_t offset) const {
    if (!exists) return {};
    std::byte* const first = memory_.get() + static_cast<std::size_t>(y) * row_bytes_ + offset;
    return {reinterpret_cast<T*>(first), static_cast<std::size_t>(width_)};
  }
  struct Unmap {
    std::size_t bytes;
    void operator()(void* memory) const;
  };
  // Notes about blank blocks stand behind the channels.
  std::size_t notes_offset() const { return depth_offset() + (has_depth_ ? padded_width() * sizeof(float) : 0); }
  std::uint32_t note(int tile_x, int tile_y) const {
    const std::byte* const row = memory_.get() + static_cast<std::size_t>(tile_y) * tile_side * row_bytes_;
    return reinterpret_cast<const std::uint32_t*>(row + notes_offset())[tile_x];
  }
  static std::unique_ptr<std::byte[], Unmap> map_memory(std::size_t bytes);

  int width_, height_;
  bool has_color_, has_depth_;
  int tiles_x_ = 0, tiles_y_ = 0;
  std::size_t row_bytes_ = 0;
  std::unique_ptr<std::byte[], Unmap> memory_;
  bool any_blank_ = false;  // false: the notes are void
};

// 32 hex digits, the same for two frames when their channels, size and every bit of their pixels are the same, and, but
// for collisions of the hash, only then. It is xxh3-128, seed 0, in its canonical (big-endian) form, over the channels
// in alphabetical order, each as: the name and a zero byte; the pixel type (1 half, 2 float) and the window (first x,
// first y, last x, last y), five 32-bit integers; the values, row by row from the top. All numbers are little-endian.
// EXR files keep the hash of their pixels, whatever their compression.
std::string pixel_hash(const FrameBuffer& frame);

// Rounds Z to the fewest mantissa bits that keep `relative_error`, as round_mantissas() does (numerics.hpp), so that it
// takes less room in files. The background's depth stays exactly what it is, as does a frame without Z. Error(usage)
// unless 0 < relative_error <= max_relative_error.
void round_depth(FrameBuffer& frame, double relative_error);

// ---- plain arrays ---------------------------------------------------------------------------------------------------
//
// 4 values a pixel (R, G, B, A), row after row from the top, without padding. Error(usage) when the frame has no
// colour.

// The values as they are stored: linear light, premultiplied by alpha.
std::vector<float> to_rgba32f(const FrameBuffer& frame);

// A colour in sRGB codes.
struct Rgb {
  std::uint8_t red = 0, green = 0, blue = 0;
  bool operator==(const Rgb&) const = default;
};

// Codes of 8 bits: colour is sRGB, alpha is linear.
//
// Without a background alpha is straight, as PNG has it: colour is divided by alpha before it is encoded, and is 0
// where alpha is 0. Each code is correctly rounded, halfway values up: these are the pixels of PNG frames (png.hpp).
// With a background the frame is put over it in linear light, and alpha is 255. Values are clamped to 0..1, alpha
// before it is used; NaN is 0.
std::vector<std::uint8_t> to_srgb8(const FrameBuffer& frame, std::optional<Rgb> background = std::nullopt);

}  // namespace morphcl
#pragma GCC visibility pop
