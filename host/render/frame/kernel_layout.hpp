// kernels/layout.h for the host: the structs that buffers hold, with their sizes checked.
#pragma once

#include <cstdint>

namespace morphcl::layout {

using uint = std::uint32_t;

#include "kernels/layout.h"

// Every member is 4 bytes wide, so device and host agree when the totals do.
static_assert(sizeof(DrawConstants) == 4 * (16 + 12 + 12 + 4 + 15));
static_assert(sizeof(TargetConstants) == 32);
static_assert(sizeof(PreciseConstants) == 80);
static_assert(sizeof(LightConstants) == 48);
static_assert(sizeof(FrameConstants) == 4 * 59);
static_assert(sizeof(ChunkStatus) == 16);
static_assert(sizeof(LargeTriangle) == 64);

inline constexpr int lanes = LANES;
inline constexpr int tile = TILE;
inline constexpr int tile_block = TILE_BLOCK;
inline constexpr int subpixel_bits = SUBPIXEL_BITS;
inline constexpr int small_pixels = SMALL_PIXELS;
inline constexpr int page = PAGE;
inline constexpr int clip_vertices = CLIP_VERTICES;
inline constexpr int groups_per_chunk = GROUPS_PER_CHUNK;
inline constexpr uint no_id = NO_ID;

}  // namespace morphcl::layout
