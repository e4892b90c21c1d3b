// A binary space partition of a picture's surfaces, and the order from back to front that it gives.
//
// Fuchs, Kedem and Naylor (1980). Projection keeps planes, so the space that is parted is the one after projection: x
// and y on the screen, and depth, in which the eye is infinitely far in front. A node is parted by the plane of one of
// its surfaces; or, where that parts badly, by a plane through the eye (a line between two columns or rows of pixels)
// or one of equal depth. What lies on both sides of a plane is split. Surfaces that share no pixel need no order: they
// stay together in a leaf.
#pragma once

#include <cstdint>

#include "host/visibility/pieces.hpp"

namespace morphcl::visibility {

struct BspNode {
  Splitter splitter;
  bool leaf = true;               // without splitter: its pieces share no pixel
  std::vector<std::uint32_t> on;  // pieces in the plane, or in the leaf
  std::int32_t front = -1, back = -1;
};

struct BspCounts {
  std::uint64_t sides = 0;                              // pieces compared with splitters
  std::uint64_t planes = 0, lines = 0, levels = 0;      // nodes by kind of their splitter
  std::uint64_t leaves = 0, splits = 0, max_depth = 0;  // of the tree
};

struct Bsp {
  std::vector<Piece> pieces;
  std::vector<BspNode> nodes;  // the root is the first
  BspCounts counts;

  // Indices of pieces. The eye is in front of all planes of surfaces: back, node, front.
  std::vector<std::uint32_t> back_to_front() const;
};

// Error(bad_input) where more pieces than max_pieces would be needed.
Bsp build_bsp(Pieces& pieces, std::size_t max_pieces);

}  // namespace morphcl::visibility
