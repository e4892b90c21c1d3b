// Pieces over each other, from back to front.
#pragma once

#include <cstdint>
#include <vector>

#include "host/visibility/pieces.hpp"
#include "host/visibility/shown_rows.hpp"

namespace morphcl::visibility {

// Every opaque piece over what was painted before it, and blended ones side by side in ShownRows::layers. Where the two
// are within their errors, the stored depths decide, and the pixel is noted where they decide otherwise.
void paint(const Pieces& pieces, const std::vector<Piece>& back_to_front, ShownRows& shown);

}  // namespace morphcl::visibility
