#include "host/image/contact_sheet.hpp"

#include <algorithm>
#include <cmath>

namespace morphcl {

namespace {

constexpr Rgb sheet_color{24, 24, 26};
constexpr Rgb label_color{190, 190, 190};
constexpr Rgb missing_color{225, 80, 70};
constexpr double sheet_proportion = 1.5;  // width to height

std::vector<std::int64_t> shown_frames(const std::vector<std::int64_t>& frames, std::size_t max_count) {
  const std::size_t step = (frames.size() + max_count - 1) / max_count;
  std::vector<std::int64_t> shown;
  for (std::size_t i = 0; i < frames.size(); i += step) shown.push_back(frames[i]);
  return shown;
}

int thumbnail_box(std::size_t cells) { return cells <= 6 ? 480 : cells <= 30 ? 320 : 192; }

}  // namespace

ContactSheet::Layout ContactSheet::layout_of(std::size_t cells, PictureSize frame) {
  Layout layout;
  const int box = thumbnail_box(cells);
  layout.thumbnail = fitted_size(frame, {box, box});
  layout.label_scale = box > 192 ? 2 : 1;
  const int count = static_cast<int>(cells);
  const double columns = std::sqrt(count * sheet_proportion * layout.cell_height() / layout.cell_width());
  layout.rows = (count - 1) / std::clamp(static_cast<int>(std::lround(columns)), 1, count) + 1;
  layout.columns = (count - 1) / layout.rows + 1;  // as few as these rows need
  return layout;
}

ContactSheet::ContactSheet(const std::vector<std::int64_t>& frames, PictureSize frame, double gain)
    : frames_(shown_frames(frames, max_cells)),
      layout_(layout_of(frames_.size(), frame)),
      gain_(gain),
      image_(layout_.gap + layout_.columns * layout_.cell_width(), layout_.gap + layout_.rows * layout_.cell_height(),
             sheet_color) {
  for (int cell = 0; cell < static_cast<int>(frames_.size()); ++cell) draw_label(cell, missing_color);
}

std::optional<RgbImage> ContactSheet::picture_of(std::int64_t frame, const FrameBuffer& pixels) const {
  if (cell_of(frame) < 0) return std::nullopt;
  return thumbnail(pixels, fitted_size({pixels.width(), pixels.height()}, layout_.thumbnail), gain_);
}

void ContactSheet::add(std::int64_t frame, const RgbImage& picture) {
  const int cell = cell_of(frame);
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) image_.at(left_of(cell) + x, top_of(cell) + y) = picture.at(x, y);
  draw_label(cell, label_color);
}

int ContactSheet::cell_of(std::int64_t frame) const {
  const auto found = std::find(frames_.begin(), frames_.end(), frame);
  return found == frames_.end() ? -1 : static_cast<int>(found - frames_.begin());
}

void ContactSheet::draw_label(int cell, Rgb color) {
  draw_text(image_, left_of(cell), top_of(cell) + layout_.thumbnail.height + layout_.gap / 2, layout_.label_scale,
            std::to_string(frames_[static_cast<std::size_t>(cell)]), color);
}

}  // namespace morphcl
