// A rendered frame in memory, its pixel hash, and its colours as plain arrays for whoever goes on with them elsewhere.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "morphcl/channel.hpp"

#pragma GCC visibility push(default)
namespace morphcl {

constexpr float background_depth = 1e10f;  // Z where nothing is drawn

// The bits of an element of the channel where nothing is drawn: 0 but for Z.
constexpr std::uint32_t background_bits(Channel channel) {
  return channel == Channel::depth ? std::bit_cast<std::uint32_t>(background_depth) : 0;
}

// A frame: the planes of its channels (channel.hpp), row after row from the top.
//
// One piece of memory holds the whole frame. A row of the picture is a row of each plane, one after the other, as in a
// scan line of an EXR file, in the order of Channel: R, G, B, A, Z, N.X and so on, of which those that were not asked
// for are left out. The next row starts row_bytes() further on. What lies in a row behind a plane's width() elements is
// padding without meaning, as are rows below the picture: both are rounded up to whole tiles (64 pixels). Every row of
// every plane starts on a cache line (64 bytes), and the frame on a page, so that OpenCL can use it in place. Every
// element is 0 until it is written, and memory is only taken where something was written.
//
// The frame knows which of its tiles are blank (background everywhere), so that a renderer need not write them again
// and an encoder need not look at them.
class FrameBuffer {
 public:
  static constexpr std::size_t tile_side = 64, block_side = 16;  // pixels

  // Pixels a side. A plane of the largest frame holds 2^30 elements.
  static constexpr int max_side = 32768;

  // Error(bad_input) for a side outside 1..max_side, Error(internal) when the memory cannot be had.
  FrameBuffer(int width, int height, ChannelSet channels);

  int width() const { return width_; }
  int height() const { return height_; }
  ChannelSet channels() const { return channels_; }
  bool has(Channel channel) const { return channels_.contains(channel); }
  bool has_color() const { return has(Channel::color); }
  bool has_depth() const { return has(Channel::depth); }

  // The width() pixels of row y (0..height() - 1, 0 at the top) in one plane of a channel (0 .. plane_count(channel) -
  // 1), which has that type: the bits of IEEE binary16, binary32, whole numbers. Empty when the frame does not have the
  // channel. A frame that is not const forgets here which of its tiles are blank, as the caller may write.
  std::span<std::uint16_t> half_row(Channel channel, int plane, int y) {
    return writable_row<std::uint16_t>(channel, plane, y);
  }
  std::span<const std::uint16_t> half_row(Channel channel, int plane, int y) const {
    return row<const std::uint16_t>(channel, plane, y);
  }
  std::span<float> float_row(Channel channel, int plane, int y) { return writable_row<float>(channel, plane, y); }
  std::span<const float> float_row(Channel channel, int plane, int y) const {
    return row<const float>(channel, plane, y);
  }
  std::span<std::uint32_t> uint_row(Channel channel, int plane, int y) {
    return writable_row<std::uint32_t>(channel, plane, y);
  }
  std::span<const std::uint32_t> uint_row(Channel channel, int plane, int y) const {
    return row<const std::uint32_t>(channel, plane, y);
  }

  // The same row of a plane of any type, as bytes.
  std::span<const std::byte> plane_row(Channel channel, int plane, int y) const {
    if (!has(channel)) return {};
    const std::byte* const first = memory_.get() + static_cast<std::size_t>(y) * row_bytes_;
    return {first + plane_offset(channel, plane), static_cast<std::size_t>(width_) * bytes_of(plane_type(channel))};
  }

  // Colour: 0 R, 1 G, 2 B, 3 A; linear light, premultiplied by alpha.
  std::span<std::uint16_t> color_row(int plane, int y) { return half_row(Channel::color, plane, y); }
  std::span<const std::uint16_t> color_row(int plane, int y) const { return half_row(Channel::color, plane, y); }
  // The positive distance along the view axis; background_depth where nothing is drawn, infinity where a depth buffer
  // other than the default holds a far plane at infinity.
  std::span<float> depth_row(int y) { return float_row(Channel::depth, 0, y); }
  std::span<const float> depth_row(int y) const { return float_row(Channel::depth, 0, y); }

  // The memory itself: pixel (x, y) of a plane is at byte y * row_bytes() + its offset + x * its element's size.
  // bytes() counts the padding, of rows below the picture too.
  std::byte* data() {
    forget_blank_tiles();
    return memory_.get();
  }
  const std::byte* data() const { return memory_.get(); }
  std::size_t row_bytes() const { return row_bytes_; }
  std::size_t bytes() const { return row_bytes_ * padded_rows(); }
  // From the start of a row; of a channel that the frame has.
  std::size_t plane_offset(Channel channel, int plane) const {
    return offsets_[static_cast<std::size_t>(channel)] +
           static_cast<std::size_t>(plane) * padded_width() * bytes_of(plane_type(channel));
  }

  // Tiles of 64 x 64 pixels, from (0, 0) at the upper left. blank(...): known to hold the background in every channel:
  // Z is background_depth, all others are 0.
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
  std::span<T> row(Channel channel, int plane, int y) const {
    if (!has(channel)) return {};
    std::byte* const first = memory_.get() + static_cast<std::size_t>(y) * row_bytes_ + plane_offset(channel, plane);
    return {reinterpret_cast<T*>(first), static_cast<std::size_t>(width_)};
  }
  template <class T>
  std::span<T> writable_row(Channel channel, int plane, int y) {
    forget_blank_tiles();
    return row<T>(channel, plane, y);
  }
  struct Unmap {
    std::size_t bytes;
    void operator()(void* memory) const;
  };
  std::uint32_t note(int tile_x, int tile_y) const {
    const std::byte* const row = memory_.get() + static_cast<std::size_t>(tile_y) * tile_side * row_bytes_;
    return reinterpret_cast<const std::uint32_t*>(row + notes_offset_)[tile_x];
  }
  static std::unique_ptr<std::byte[], Unmap> map_memory(std::size_t bytes);

  int width_, height_;
  ChannelSet channels_;
  int tiles_x_ = 0, tiles_y_ = 0;
  std::array<std::size_t, channel_count> offsets_{};  // of each channel's first plane
  std::size_t notes_offset_ = 0;                      // notes about blank blocks stand behind the planes
  std::size_t row_bytes_ = 0;
  std::unique_ptr<std::byte[], Unmap> memory_;
  bool any_blank_ = false;  // false: the notes are void
};

// 32 hex digits, the same for two frames when their channels, size and every bit of their pixels are the same, and, but
// for collisions of the hash, only then. It is xxh3-128, seed 0, in its canonical (big-endian) form, over the planes in
// the order of their plain names' bytes (docs/channels.md), each as: the name and a zero byte; the pixel type (0 uint,
// 1 half, 2 float) and the window (first x, first y, last x, last y), five 32-bit integers; the values, row by row from
// the top. All numbers are little-endian. EXR files keep the hash of their pixels, whatever their compression and the
// names they give the planes.
std::string pixel_hash(const FrameBuffer& frame);

// Rounds Z to the fewest mantissa bits that keep `relative_error`, as round_mantissas() does (numerics.hpp), so that it
// takes less room in files. The background's depth stays exactly what it is, as does a frame without Z. Error(usage)
// unless 0 < relative_error <= max_relative_error.
void round_depth(FrameBuffer& frame, double relative_error);

// The same of each component of P: the error is relative to the component itself. Zeros stay.
void round_position(FrameBuffer& frame, double relative_error);

// Rounds each component of N to the nearest multiple, ties to even, of step_for(absolute_error) (numerics.hpp), so that
// it moves by no more than that. What is rounded is a half again; normals are no longer of exactly unit length.
// Error(usage) as step_for() has it.
void round_normal(FrameBuffer& frame, double absolute_error);

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
