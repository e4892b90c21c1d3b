// One picture of a sequence: small frames in a grid with their numbers, as an sRGB PNG.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "host/image/font.hpp"
#include "host/image/thumbnail.hpp"

namespace morphcl {

// Frames are added as they come, in any order, and are not kept. A frame that was never added shows as an empty cell
// with a red number. Of more than max_cells frames the sheet shows every second, third, ... so that it stays a picture.
class ContactSheet {
 public:
  static constexpr std::size_t max_cells = 400;

  // `frames` (at least one) in the order of the cells, row by row; `frame` is their size in pixels; colours are
  // multiplied by `gain`.
  ContactSheet(const std::vector<std::int64_t>& frames, PictureSize frame, double gain = 1);

  bool shows(std::int64_t frame) const { return cell_of(frame) >= 0; }
  // What the frame's cell is to show; nothing for a frame that the sheet does not show. Error(usage) when the frame has
  // no colour; a frame of another size is fitted into its cell.
  std::optional<RgbImage> picture_of(std::int64_t frame, const FrameBuffer& pixels) const;
  // Puts such a picture into the cell. Both may be called for several frames at the same time.
  void add(std::int64_t frame, const RgbImage& picture);
  void add(std::int64_t frame, const FrameBuffer& pixels) {
    if (const std::optional<RgbImage> picture = picture_of(frame, pixels)) add(frame, *picture);
  }

  const RgbImage& image() const { return image_; }
  void write(const std::string& path) const { write_png(path, image_); }

 private:
  struct Layout {
    PictureSize thumbnail;
    int columns = 1, rows = 1, label_scale = 1, gap = 8;
    int cell_width() const { return thumbnail.width + gap; }
    int label_height() const { return glyph_height * label_scale + gap / 2; }
    int cell_height() const { return thumbnail.height + label_height() + gap; }
  };
  static Layout layout_of(std::size_t cells, PictureSize frame);
  int cell_of(std::int64_t frame) const;  // -1: not shown
  int left_of(int cell) const { return layout_.gap + cell % layout_.columns * layout_.cell_width(); }
  int top_of(int cell) const { return layout_.gap + cell / layout_.columns * layout_.cell_height(); }
  void draw_label(int cell, Rgb color);

  std::vector<std::int64_t> frames_;
  Layout layout_;
  double gain_;
  RgbImage image_;
};

}  // namespace morphcl
