// How much room the bins of a frame get, and where it is: the one place that knows.
#pragma once

#include <cstddef>

#include "host/render/frame/kernel_layout.hpp"

namespace morphcl {

// Room of one chunk's bins, and of all clipped primitives. It starts from a guess and grows to what a frame was found
// to need.
struct BinPools {
  layout::uint primitives_a_page = 32;  // of fragments, in the guess
  layout::uint fragment_pages = 0, entry_pages = 0, large = 0, clipped = 256;

  void grow_to(const layout::ChunkStatus& chunk);
  void grow_to_clipped(layout::uint needed);
};

// Of frames of so many samples a pixel: at several a small triangle leaves fragments at two to three times as many
// pixels as at one.
inline BinPools pools_of(int samples) { return {.primitives_a_page = samples > 1 ? 16u : 32u}; }

// Chunks of vertex groups; those of the last one may be fewer.
layout::uint vertex_chunk_count(const layout::FrameConstants& constants);

// Bytes of the buffers. Fragments are keys, or, of several samples a pixel, sample fragments.
struct BinSizes {
  std::size_t bins, fragment_keys, sample_fragments, large, clipped;
};

// Shares out a frame's primitives to chunks, and sets chunk_count, primitive_groups_per_chunk, capacities and offsets
// in the constants, whose size and numbers of groups are set. Chunks are a matter of load only: enough of them for the
// threads, each big enough to be worth its bins, but so few that `bins` is no larger than what the device allocates at
// once. Pools that are too small for a guess at the frame grow.
// `id_bytes`: of the tables of ids of a band, in `bins` too.
BinSizes lay_out_bins(std::size_t max_allocation, BinPools& pools, layout::FrameConstants& constants,
                      std::size_t id_bytes = 0);

}  // namespace morphcl
