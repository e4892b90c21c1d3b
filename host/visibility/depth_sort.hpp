// The painter's algorithm: pieces in an order from back to front, found by sorting on depth.
//
// Newell, Newell and Sancha (1972): surfaces are sorted by their farthest depth. The farthest, P, may be painted when
// it hides no other that is not painted yet. Each other Q is tried against P by tests that grow dearer: do their depths
// overlap (min-max in z), their boxes on the screen (min-max in x, y), is P behind Q's plane, is Q in front of P's
// plane, do they share pixels, and which of the two is nearer where they do. If P hides Q, Q comes first, and is asked
// the same; if that leads back to a surface that waits already, they overlap in a circle and one of them is split by
// the plane of another. Two that cut each other are split at once.
//
// Differences that are smaller than the errors of depth ask for no order: paint() settles these pixel by pixel.
#pragma once

#include <cstdint>

#include "host/visibility/pieces.hpp"

namespace morphcl::visibility {

// What sorting did, for those who want to see it.
struct DepthSortCounts {
  std::uint64_t pairs = 0;           // of surfaces whose boxes meet on the screen and whose depths may ask for an order
  std::uint64_t min_max_depth = 0;   // of these, rejected: the first is behind the second altogether
  std::uint64_t min_max_screen = 0;  // pieces' boxes do not meet
  std::uint64_t behind_plane = 0;    // P is behind Q's plane
  std::uint64_t in_front_of_plane = 0;  // Q is in front of P's plane
  std::uint64_t apart = 0;              // they share no pixel
  std::uint64_t behind = 0;             // P is behind Q where they share pixels, or within the error
  std::uint64_t moved = 0;              // Q came before P
  std::uint64_t circles = 0;            // overlaps in a circle
  std::uint64_t cuts = 0;               // surfaces that cut each other
  std::uint64_t splits = 0;
};

struct DepthSort {
  std::vector<Piece> back_to_front;
  DepthSortCounts counts;
};

// Error(bad_input) where more pieces than max_pieces would be needed.
DepthSort sort_by_depth(Pieces& pieces, std::size_t max_pieces);

}  // namespace morphcl::visibility
