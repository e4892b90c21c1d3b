// The reference's view of kernels/bin_primitives.cl and the first half of kernels/shade_tiles.cl: every primitive over
// every pixel of its box, one visibility sample a pixel.
#pragma once

#include <cstdint>
#include <vector>

#include "host/render/frame/scene_vertices.hpp"

namespace morphcl::reference {

// The primitive that a pixel shows; order compares in drawing order and is no_order where nothing is seen.
struct Sample {
  float depth;        // near / distance, in parallel projections minus the distance, as the depth buffer has it
  std::uint32_t key;  // of a forward depth buffer
  std::uint64_t order;
  std::uint32_t draw, primitive;
  std::uint32_t piece;  // index into the clipped triangles of the frame, or no_piece
};
constexpr std::uint64_t no_order = ~std::uint64_t{0};
constexpr std::uint32_t no_piece = ~std::uint32_t{0};

// A triangle that clipping left, with its corners' weights at the source triangle's vertices.
struct Piece {
  ScreenVertex corner[3];
  float weight[3][3];
};

struct Visibility {
  std::vector<Sample> samples;  // row by row, width * height
  std::vector<Piece> pieces;
};

Visibility find_visible(const FramePlan& plan, const RasterGrid& grid,
                        const std::vector<std::vector<Vertex>>& vertices);

}  // namespace morphcl::reference
