// Boxes on the screen, to be asked which of them meet a box: grids of cells of 16 pixels, 32, 64 and so on; a box lies
// in the grid whose cells are not smaller than it, so in four cells at most.
#pragma once

#include <cstdint>
#include <vector>

#include "host/visibility/screen_surfaces.hpp"

namespace morphcl::visibility {

class OverlapGrid {
 public:
  OverlapGrid(int width, int height);

  // In ascending order of `key`.
  void add(std::uint32_t item, const PixelBox& box, double key);

  // visit(item) for every item whose box meets this one and whose key is less than `below`; once each. Items for which
  // is_gone(item) holds are forgotten where that is cheap.
  template <class IsGone, class Visit>
  void for_each_meeting(const PixelBox& box, double below, IsGone is_gone, Visit visit) {
    for (Level& level : levels_) {
      if (level.empty) continue;
      const PixelBox cells = level.cells_of(box);
      for (int row = cells.first_y; row <= cells.last_y; ++row)
        for (int column = cells.first_x; column <= cells.last_x; ++column) {
          Cell& cell = level.at(column, row);
          while (cell.first < cell.entries.size() && is_gone(cell.entries[cell.first].item)) ++cell.first;
          for (std::size_t i = cell.first; i < cell.entries.size() && cell.entries[i].key < below; ++i) {
            const Entry& entry = cell.entries[i];
            if (!entry.box.meets(box)) continue;
            // An item in several cells is met in the first that it shares with the box.
            const int x = std::max(box.first_x, entry.box.first_x) >> level.bits,
                      y = std::max(box.first_y, entry.box.first_y) >> level.bits;
            if (x == column && y == row) visit(entry.item);
          }
        }
    }
  }

 private:
  struct Entry {
    PixelBox box;
    double key;
    std::uint32_t item;
  };
  struct Cell {
    std::vector<Entry> entries;
    std::size_t first = 0;
  };
  struct Level {
    int bits = 0, columns = 0;
    bool empty = true;
    std::vector<Cell> cells;

    PixelBox cells_of(const PixelBox& box) const {
      return {box.first_x >> bits, box.first_y >> bits, box.last_x >> bits, box.last_y >> bits};
    }
    Cell& at(int column, int row) {
      return cells[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                   static_cast<std::size_t>(column)];
    }
  };
  std::vector<Level> levels_;
};

}  // namespace morphcl::visibility
