// A rendered frame in host memory: planar half R, G, B, A and float Z.
//
// Rows run from top to bottom; row y starts at element y * row_pitch(). row_pitch is the width rounded up to whole
// tiles (64 pixels) and rows are rounded up likewise, so that kernels store whole vectors; what lies outside width x
// height is padding without meaning. Planes start on a page (planes of 2 MB and more on a huge page) so that OpenCL can
// use them in place. Every element is 0 until it is written, and memory is only taken where something was written.
// Planes that were not asked for are not allocated.
//
// The frame knows which of its tiles are blank (background everywhere), so that a renderer need not write them again
// and an encoder need not look at them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

namespace morphcl {

class FrameBuffer {
 public:
  // Pixels a side. A plane of the largest frame holds 2^30 elements.
  static constexpr int max_side = 32768;

  // Error(bad_input) for a side outside 1..max_side, Error(internal) when the memory cannot be had.
  FrameBuffer(int width, int height, bool color, bool depth);

  int width() const { return width_; }
  int height() const { return height_; }
  std::size_t row_pitch() const { return row_pitch_; }
  std::size_t plane_elements() const { return row_pitch_ * padded_rows_; }
  bool has_color() const { return color_[0] != nullptr; }
  bool has_depth() const { return depth_ != nullptr; }

  // channel: 0 R, 1 G, 2 B, 3 A; the bits of IEEE binary16. Colour is premultiplied by alpha. Whoever can write to a
  // plane may: no tile counts as blank from then on.
  std::uint16_t* color(int channel) {
    forget_blank_tiles();
    return color_[channel].get();
  }
  const std::uint16_t* color(int channel) const { return color_[channel].get(); }
  // Positive distance along the view axis; background 1e10.
  float* depth() {
    forget_blank_tiles();
    return depth_.get();
  }
  const float* depth() const { return depth_.get(); }

  // Tiles of 64 x 64 pixels. blank(...): known to hold 0 in every colour plane and the background's depth.
  int tiles_x() const { return static_cast<int>(row_pitch_ / tile_side); }
  int tiles_y() const { return static_cast<int>(padded_rows_ / tile_side); }
  bool blank(int tile_x, int tile_y) const {
    return any_blank_ && blank_blocks_[static_cast<std::size_t>(tile_y) * tiles_x() + tile_x] == all_blocks;
  }

  // The same of a block of 16 x 16 pixels.
  bool blank_block(int block_x, int block_y) const {
    const std::size_t tile = static_cast<std::size_t>(block_y / 4) * tiles_x() + block_x / 4;
    return any_blank_ && (blank_blocks_[tile] >> (block_y % 4 * 4 + block_x % 4) & 1u) != 0;
  }
  int blocks_x() const { return tiles_x() * 4; }

  // For a renderer, which keeps the notes true to what it writes: one for each tile, row by row; bit b is set when the
  // tile's block b of 16 x 16 pixels (four a row) is blank.
  struct Planes {
    std::uint16_t* color[4];
    float* depth;
    std::uint32_t* blank_blocks;
    std::size_t tiles;
    bool notes_hold;  // false: the notes are void, others may have written to the planes since they were made
  };
  Planes planes();

  static constexpr std::size_t tile_side = 64, block_side = 16;

 private:
  static constexpr std::uint32_t all_blocks = 0xffff;
  void forget_blank_tiles() { any_blank_ = false; }
  struct Unmap {
    std::size_t bytes;
    void operator()(void* plane) const;
  };
  template <class T>
  static std::unique_ptr<T[], Unmap> map_plane(std::size_t elements);

  int width_, height_;
  std::size_t row_pitch_ = 0, padded_rows_ = 0;
  std::unique_ptr<std::uint16_t[], Unmap> color_[4];
  std::unique_ptr<float[], Unmap> depth_;
  std::unique_ptr<std::uint32_t[], Unmap> blank_blocks_;
  bool any_blank_ = false;  // false: blank_blocks_ is void
};

constexpr float background_depth = 1e10f;

}  // namespace morphcl
