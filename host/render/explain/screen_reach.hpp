// Which tiles of a picture a frame's objects may touch; the others stay blank.
#pragma once

#include <vector>

#include "host/render/frame/frame_plan.hpp"

namespace morphcl {

struct ScreenReach {
  int tile_columns = 0, tile_rows = 0;  // tiles of 64 x 64 pixels, those at the right and lower edge cut
  std::vector<char> reached;            // row by row
  std::size_t reached_tiles = 0;
  double reached_pixels = 0;  // of the reached tiles
  int blank_rows = 0;         // rows of pixels that cross no reached tile
};

// Method: the corners of each object's morphed bounding box are projected and the tiles of their rectangle marked, one
// pixel wider for rounding; a box that reaches to the near plane or behind it marks all.
ScreenReach find_reach(const FramePlan& plan);

}  // namespace morphcl
