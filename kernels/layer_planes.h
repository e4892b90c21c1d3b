// Layers sorted: the blended surfaces of a row of blocks in planes, plane 0 the nearest of each sample. A part of
// layers.h.
//
// Planes are those of sample_planes.h, and of one sample a pixel alike: block by block, in a block row by row, SAMPLES
// vectors a row.

#ifndef MORPHCL_LAYER_PLANES_H
#define MORPHCL_LAYER_PLANES_H

#include "depth_format.h"
#include "layout.h"
#include "raster.h"
#include "tables.h"
#include "tile.h"
#include "vector.h"

#define STRIP_ROWS (TILE_BLOCKS * TILE_BLOCK)  // of a row of blocks: the rows of one after those of the other
#define STRIP_VECTORS (STRIP_ROWS * SAMPLES)

#define MAX_PLANES LAYER_PLANES(SAMPLES)

// Vector i of plane p is element p * STRIP_VECTORS + i. Each vector has its own order of planes: of what covers all of
// its lanes the planes' numbers move, not what they hold.
typedef struct {
  Depths depth[MAX_PLANES * STRIP_VECTORS];
  uint16 rank[MAX_PLANES * STRIP_VECTORS];  // id + 1; 0 where a sample has no such layer
  uchar order[STRIP_VECTORS][MAX_PLANES];   // numbers of planes, from the front
  uchar count[STRIP_VECTORS];               // planes in use
  uchar has_gaps[STRIP_VECTORS];            // in some plane some lane is empty
  Depths last_depth[STRIP_VECTORS];         // of the last plane in the pass before
  uint16 last_rank[STRIP_VECTORS];
  uint pass;
  bool more;  // some layer found no plane
} LayerPlanes;

// The lists of blended surfaces of all chunks for one tile.
typedef struct {
  global const FrameConstants* frame;
  global BinsHeader* bins;
  global Fragment* fragments;
  global LargeTriangle* large;
  uint tile;
} BlendedLists;

#if SAMPLES == 1
ALWAYS_INLINE int vector_in_tile(int block, int row, int k) {
  return (row_of(block) + row) * ROW_VECTORS + column_of(block) / LANES;
}
#else
ALWAYS_INLINE int vector_in_tile(int block, int row, int k) { return block * BLOCK_VECTORS + row * SAMPLES + k; }
#endif

// ---- sorting --------------------------------------------------------------------------------------------------------

// Takes the lanes of `rank` that are not 0, of vector k of a row of a block, to their places, if the opaque surface
// does not hide them.
static inline void sort_in(LayerPlanes* planes, Tile tile, int block, int row, int k, Depths depth, uint16 rank) {
  const int in_tile = vector_in_tile(block, row, k);
  const Depths opaque = tile.depth[in_tile];
  const uint16 opaque_rank = tile.id[in_tile] + 1u;  // 0 on the background
  rank &= as_uint16((depth > opaque) | ((depth == opaque) & (rank > opaque_rank)));
  const int at = (block % TILE_BLOCKS * TILE_BLOCK + row) * SAMPLES + k;
  if (planes->pass) {
    const Depths last = planes->last_depth[at];
    const uint16 last_rank = planes->last_rank[at];
    rank &= as_uint16((depth < last) | ((depth == last) & (rank < last_rank)));
  }
  const uint count = planes->count[at];
  uchar* order = planes->order[at];
  const bool whole = !planes->has_gaps[at] && !any_lane(rank == 0u);
  for (uint place = 0; place < count; place++) {
    const uint i = order[place] * STRIP_VECTORS + at;
    const Depths held = planes->depth[i];
    const uint16 held_rank = planes->rank[i];
    const int16 nearer = (rank != 0u) & ((depth > held) | ((depth == held) & (rank > held_rank)));
    if (!any_lane(nearer)) continue;
    if (whole && !any_lane(~nearer)) {
      const bool full = count == MAX_PLANES;
      const uint plane = full ? order[MAX_PLANES - 1] : count;
      for (uint behind = full ? MAX_PLANES - 1 : count; behind > place; behind--) order[behind] = order[behind - 1];
      order[place] = (uchar)plane;
      planes->depth[plane * STRIP_VECTORS + at] = depth;
      planes->rank[plane * STRIP_VECTORS + at] = rank;
      planes->count[at] = (uchar)(full ? count : count + 1);
      planes->more |= full;
      return;
    }
    planes->depth[i] = select(held, depth, nearer);
    planes->rank[i] = select(held_rank, rank, as_uint16(nearer));
    depth = select(depth, held, nearer);
    rank = select(rank, held_rank, as_uint16(nearer));
    if (!any_lane(rank != 0u)) return;
  }
  if (!any_lane(rank != 0u)) return;
  if (count == MAX_PLANES) {
    planes->more = true;
    return;
  }
  order[count] = (uchar)count;
  planes->depth[count * STRIP_VECTORS + at] = select((Depths)(FARTHEST_DEPTH), depth, rank != 0u);
  planes->rank[count * STRIP_VECTORS + at] = rank;
  planes->has_gaps[at] |= any_lane(rank == 0u);
  planes->count[at] = (uchar)(count + 1);
}

// A pixel of the tile that a fragment covers.
typedef struct {
  int block, row, column;
} PixelInTile;

#if SAMPLES == 1
ALWAYS_INLINE PixelInTile pixel_of_fragment(ChunkBins own, uint i) {
  const int place = own.fragment_places[i], x = place & (TILE - 1), y = place >> TILE_BITS;
  const PixelInTile pixel = {y / TILE_BLOCK * TILE_BLOCKS + x / TILE_BLOCK, y % TILE_BLOCK, x % TILE_BLOCK};
  return pixel;
}
static inline void sort_in_fragment(LayerPlanes* planes, Tile tile, PixelInTile pixel, Fragment f) {
  const uint16 rank = (uint16)((uint)f + 1u) & as_uint16(LANE == pixel.column);
  sort_in(planes, tile, pixel.block, pixel.row, 0, (Depths)(depth_from_bits((uint)(f >> 32))), rank);
}
#else
ALWAYS_INLINE PixelInTile pixel_of_fragment(ChunkBins own, uint i) {
  const int place = (int)(own.fragments[i].place_and_mask & ((1u << PLACE_IN_TILE_BITS) - 1));
  const PixelInTile pixel = {place >> 8, place >> 4 & (TILE_BLOCK - 1), place & (TILE_BLOCK - 1)};
  return pixel;
}
static inline void sort_in_fragment(LayerPlanes* planes, Tile tile, PixelInTile pixel, Fragment f) {
  const int16 covered = (LANE / SAMPLES == pixel.column % VECTOR_PIXELS) &
                        ((f.place_and_mask >> PLACE_IN_TILE_BITS & ((uint16)(1u) << as_uint16(LANE % SAMPLES))) != 0u);
#ifdef FORWARD_DEPTH
  const Depths depth = f.depth;
#else
  const Depths depth = fma((float16)(f.depth_dx), convert_float16(SAMPLE_X_OF_LANES) * PIXELS_OF_SAMPLE_UNIT,
                           fma((float16)(f.depth_dy), convert_float16(SAMPLE_Y_OF_LANES) * PIXELS_OF_SAMPLE_UNIT,
                               (float16)(as_float(f.depth))));
#endif
  sort_in(planes, tile, pixel.block, pixel.row, pixel.column / VECTOR_PIXELS, depth,
          (uint16)(f.id + 1u) & as_uint16(covered));
}
#endif

// Sorts in what a large triangle covers in rows first..last of the tile, all in one block.
static inline void sort_in_rows(LayerPlanes* planes, Tile tile, const TileEdges* edges, global const LargeTriangle* t,
                                TileDepth origin, int block, int first, int last) {
  const int column = column_of(block);
  for (int y = first; y <= last; y++) {
#if SAMPLES == 1
    const int16 min_value = min_edge_values(edges, column, y);
    const int16 covered = (min_value >= 0) & in_range(t, origin, column, y);
    const Depths depth = any_lane(beside_edges(edges, min_value))
                             ? depths_beside_edges(t, origin, tile.x, tile.y, column, y)
                             : depths_in_row(t, origin, column, y);
    sort_in(planes, tile, block, y - row_of(block), 0, depth, (uint16)(t->id + 1u) & as_uint16(covered));
#else
    const SampleRow samples = sample_row(t, origin, column, y);
    for (int k = 0; k < SAMPLES; k++) {
      int16 inside = 0;
      FOR_THREE(e)
      inside |= edges->value[e] + edges->to_sample[e] +
                edges->step_x[e] * (LANE / SAMPLES + (column + k * VECTOR_PIXELS)) + edges->step_y[e] * y;
      const int16 covered = (inside >= 0) & samples_in_range(&samples, k);
      sort_in(planes, tile, block, y - row_of(block), k, depths_of_samples(&samples, k),
              (uint16)(t->id + 1u) & as_uint16(covered));
    }
#endif
  }
}

// The blocks of the tile in which the triangle may show something, -1 a lane, and its edges there.
static inline int16 reached_blocks(Tile tile, const Blocks* blocks, global const LargeTriangle* t, TileDepth origin,
                                   bool entire_tile, TileEdges* edges) {
  const TileBox box = box_of(t, tile);
  const int16 left = max(BLOCK_X, (int16)(box.first_column)),
              right = min(BLOCK_X + (TILE_BLOCK - 1), (int16)(box.last_column));
  const int16 top = max(BLOCK_Y, (int16)(box.first_row)),
              bottom = min(BLOCK_Y + (TILE_BLOCK - 1), (int16)(box.last_row));
  const DepthBounds depth = depths_in_boxes(t, origin, left, right, top, bottom);
  int16 misses = (left > right) | (top > bottom) | (depth.max < blocks->min), covers = 0;
  if (!any_lane(~misses)) return 0;
  if (entire_tile)
    pass_all_edges(edges);
  else
    find_covered_blocks(t, tile, edges, &misses, &covers);
  return ~misses;
}

// The blocks, a bit each, that blended surfaces may touch.
static inline uint blocks_with_layers(const BlendedLists* lists, Tile tile, const Blocks* blocks) {
  uint found = 0;
  for (uint chunk = 0; chunk < lists->frame->chunk_count; chunk++) {
    const ChunkBins own = bins_of_chunk(chunk, lists->frame, lists->bins, lists->fragments, lists->large);
    for (uint head = own.blended_fragment_heads[lists->tile]; head; head = head_before(own.fragment_next, head))
      for (uint i = first_of_page(head); i < head; i++) found |= 1u << pixel_of_fragment(own, i).block;
    for (uint head = own.blended_entry_heads[lists->tile]; head; head = head_before(own.entry_next, head))
      for (uint i = first_of_page(head); i < head; i++) {
        const uint entry = own.entry_triangles[i];
        global const LargeTriangle* t = &own.large[entry & ~ENTIRE_TILE];
        TileEdges edges;
        found |= bits_of_mask(
            reached_blocks(tile, blocks, t, depth_of_tile(t, tile.x, tile.y), (entry & ENTIRE_TILE) != 0, &edges));
      }
  }
  return found;
}

// One pass over the layers of a row of blocks, `strip` from the top.
static inline void sort_layers(LayerPlanes* planes, const BlendedLists* lists, Tile tile, const Blocks* blocks,
                               int strip) {
  planes->more = false;
  for (int i = 0; i < STRIP_VECTORS; i++) planes->count[i] = planes->has_gaps[i] = 0;
  for (uint chunk = 0; chunk < lists->frame->chunk_count; chunk++) {
    const ChunkBins own = bins_of_chunk(chunk, lists->frame, lists->bins, lists->fragments, lists->large);
    for (uint head = own.blended_fragment_heads[lists->tile]; head; head = head_before(own.fragment_next, head))
      for (uint i = first_of_page(head); i < head; i++) {
        const PixelInTile pixel = pixel_of_fragment(own, i);
        if (pixel.block / TILE_BLOCKS == strip) sort_in_fragment(planes, tile, pixel, own.fragments[i]);
      }
    for (uint head = own.blended_entry_heads[lists->tile]; head; head = head_before(own.entry_next, head))
      for (uint i = first_of_page(head); i < head; i++) {
        const uint entry = own.entry_triangles[i];
        global const LargeTriangle* t = &own.large[entry & ~ENTIRE_TILE];
        const TileBox box = box_of(t, tile);
        const int first = max(strip * TILE_BLOCK, box.first_row),
                  last = min(strip * TILE_BLOCK + TILE_BLOCK - 1, box.last_row);
        if (first > last) continue;
        const TileDepth origin = depth_of_tile(t, tile.x, tile.y);
        TileEdges edges;
        const int16 reached = reached_blocks(tile, blocks, t, origin, (entry & ENTIRE_TILE) != 0, &edges);
        FOR_EACH_LANE(block, reached & (LANE / TILE_BLOCKS == strip))
        sort_in_rows(planes, tile, &edges, t, origin, block, first, last);
      }
  }
}

#endif
