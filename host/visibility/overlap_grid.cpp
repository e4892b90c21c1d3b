#include "host/visibility/overlap_grid.hpp"

namespace morphcl::visibility {

OverlapGrid::OverlapGrid(int width, int height) {
  constexpr int smallest_bits = 4;
  for (int bits = smallest_bits;; ++bits) {
    Level level;
    level.bits = bits;
    level.columns = (std::max(width - 1, 0) >> bits) + 1;
    const int rows = (std::max(height - 1, 0) >> bits) + 1;
    level.cells.resize(static_cast<std::size_t>(level.columns) * static_cast<std::size_t>(rows));
    const bool last = level.cells.size() == 1;
    levels_.push_back(std::move(level));
    if (last) return;
  }
}

void OverlapGrid::add(std::uint32_t item, const PixelBox& box, double key) {
  const int extent = std::max(box.last_x - box.first_x, box.last_y - box.first_y) + 1;
  std::size_t fitting = 0;
  while (fitting + 1 < levels_.size() && (1 << levels_[fitting].bits) < extent) ++fitting;
  Level& level = levels_[fitting];
  level.empty = false;
  const PixelBox cells = level.cells_of(box);
  for (int row = cells.first_y; row <= cells.last_y; ++row)
    for (int column = cells.first_x; column <= cells.last_x; ++column)
      level.at(column, row).entries.push_back({box, key, item});
}

}  // namespace morphcl::visibility
