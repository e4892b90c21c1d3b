// kernels/layout.h for the host: the structs that buffers hold, with their sizes checked, and the constants of the
// raster design. Nobody else states them.
#pragma once

#include <cstdint>

#include "host/render/frame/camera_constants.hpp"
#include "morphcl/depth_format.hpp"

namespace morphcl::layout {

using uint = std::uint32_t;
using ulong = std::uint64_t;

#include "kernels/layout.h"

// The records of vertices, attributes and colours.
struct Int4 {
  std::int32_t x, y, z, w;
};

// The host knows the default's layout of this struct alone; the others have its size.
static_assert(sizeof(LargeTriangle) == 64);
// Members are 4 bytes wide, or 8 and in front, so device and host agree when the totals do.
static_assert(sizeof(DrawConstants) == 4 * (16 + 12 + 12 + 4 + 17));
static_assert(sizeof(TargetConstants) == 32);
static_assert(sizeof(PreciseConstants) == 80);
static_assert(sizeof(LightConstants) == 64);
static_assert(sizeof(ClippedPrimitive) == 104);
static_assert(sizeof(BinsOffsets) == 88);
static_assert(sizeof(FrameConstants) == sizeof(BinsOffsets) + sizeof(CameraConstants) + 4 * 53);
static_assert(sizeof(ChunkStatus) == 16);
static_assert(sizeof(SampleFragment) == 20);
static_assert(sizeof(BinsHeader) == 64);
static_assert(sizeof(TileIds) == 128);
static_assert(sizeof(ChannelConstants) == 4 * (4 + CHANNELS + 12 + 4));
static_assert(sizeof(ChannelDraw) == 48);

static_assert(static_cast<int>(DepthFormat::reversed_float) == DEPTH_REVERSED_FLOAT &&
              static_cast<int>(DepthFormat::forward_float) == DEPTH_FLOAT &&
              static_cast<int>(DepthFormat::fixed16) == DEPTH_FIXED_16 &&
              static_cast<int>(DepthFormat::fixed24) == DEPTH_FIXED_24 &&
              static_cast<int>(DepthFormat::fixed32) == DEPTH_FIXED_32);

// The kernels lean on these.
static_assert(TILE_BLOCK == LANES, "a row of a block is one vector");
static_assert(TILE_BLOCKS * TILE_BLOCKS == LANES, "a tile's blocks are the lanes of one vector");
static_assert(2 * TILE_BITS <= 16, "a place in a tile is a ushort");
static_assert(PLACE_IN_TILE_BITS == 2 * TILE_BITS && PLACE_IN_TILE_BITS + MAX_SAMPLES <= 32);
static_assert(CLIP_VERTICES == 3 + CLIP_PLANES, "each plane that cuts a triangle adds a corner");
static_assert(CLIP_VERTICES <= PIECES, "the pieces of a clipped primitive have numbers");
static_assert((PAGE & (PAGE - 1)) == 0, "entries of a page are counted by a mask");
static_assert(LANES == 16, "vectors are float16 and int16");
static_assert(2 * (TILE_BITS + SUBPIXEL_BITS) + 1 < 31, "edge values of triangles of a tile's size fit 32 bits");
static_assert(MAX_SUBPIXEL * 4 * TILE <= 0x1p31f, "edge values in a tile fit 32 bits");

inline constexpr int lanes = LANES;
inline constexpr int tile = TILE;
inline constexpr int tile_block = TILE_BLOCK;
inline constexpr int subpixel_bits = SUBPIXEL_BITS;
inline constexpr int corner_units = CORNER_UNITS;
inline constexpr int subpixels = SUBPIXELS;
inline constexpr int half_pixel = HALF_PIXEL;
inline constexpr int small_pixels = SMALL_PIXELS;
inline constexpr int page = PAGE;
inline constexpr int clip_vertices = CLIP_VERTICES;
inline constexpr int piece_bits = PIECE_BITS;
inline constexpr int vertex_groups_per_chunk = VERTEX_GROUPS_PER_CHUNK;
inline constexpr uint no_id = NO_ID;
inline constexpr float max_subpixel = MAX_SUBPIXEL;
inline constexpr float max_guard = MAX_GUARD;
inline constexpr float max_clip_coordinate = MAX_CLIP_COORDINATE;
inline constexpr float max_normalized_depth = MAX_NORMALIZED_DEPTH;
inline constexpr float min_normal_square = MIN_NORMAL_SQUARE;
inline constexpr float background_depth = BACKGROUND_DEPTH;

}  // namespace morphcl::layout
