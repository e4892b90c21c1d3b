// What is visible in a tile of 64 x 64 pixels: for each sample depth and id, kept block by block (16 x 16 samples).
//
// A block that nothing touched, or that one large triangle covers in front of all it held, is no more than a note;
// samples are written when something covers a part of it. The minimum and maximum depth of every block tell which
// triangles it hides (hierarchical depth). All sixteen blocks of the tile are judged at once, one a lane.

#ifndef MORPHCL_TILE_H
#define MORPHCL_TILE_H

#include "depth_format.h"
#include "layout.h"
#include "raster.h"
#include "tables.h"
#include "vector.h"

#define CLEAR NO_ID            // a block that nothing touched
#define PER_PIXEL (NO_ID - 1)  // a block whose samples stand in the tile's planes; else a block is one large triangle

// Where a tile's samples are while it is drawn. A CPU's local memory is memory like any other; and PoCL 3.1 gives a
// local array that a kernel declares to all threads at once.
#ifdef MORPHCL_POCL
#define TILE_MEMORY private
#else
#define TILE_MEMORY local
#endif

// Samples of the tile, 16 of a row in a vector: rows of ROW_VECTORS vectors.
#define ROW_VECTORS (TILE / LANES)
typedef struct {
  TILE_MEMORY Depths* depth;
  TILE_MEMORY uint16* id;
  int x, y;  // first pixel
} Tile;

// The 4 x 4 blocks of a tile, one a lane.
#define BLOCK_X (LANE % TILE_BLOCKS * TILE_BLOCK)
#define BLOCK_Y (LANE / TILE_BLOCKS * TILE_BLOCK)
static inline int column_of(int block) { return (int)((uint)block % TILE_BLOCKS * TILE_BLOCK); }
static inline int row_of(int block) { return (int)((uint)block / TILE_BLOCKS * TILE_BLOCK); }

typedef struct {
  uint16 content;   // CLEAR, PER_PIXEL or the index of a large triangle
  Depths min, max;  // depths in the block
} Blocks;

// ---- fragments ------------------------------------------------------------------------------------------------------

static inline void merge_fragments(Tile tile, ChunkBins bins, uint head) {
  TILE_MEMORY Depth* depths = (TILE_MEMORY Depth*)tile.depth;
  TILE_MEMORY uint* ids = (TILE_MEMORY uint*)tile.id;
  while (head) {
    for (uint i = first_of_page(head); i < head; i++) {
      const ulong key = bins.fragment_keys[i];
      const Depth depth = depth_from_bits((uint)(key >> 32));
      const uint id = (uint)key;
      const int place = bins.fragment_places[i];
      const Depth held = depths[place];
      if (depth > held || (depth == held && id < ids[place])) {
        depths[place] = depth;
        ids[place] = id;
      }
    }
    head = head_before(bins.fragment_next, head);
  }
}

static inline void place_fragments(Tile tile, ChunkBins bins, uint head) {
  TILE_MEMORY Depth* depths = (TILE_MEMORY Depth*)tile.depth;
  TILE_MEMORY uint* ids = (TILE_MEMORY uint*)tile.id;
  while (head) {
    for (uint i = first_of_page(head); i < head; i++) {
      const ulong key = bins.fragment_keys[i];
      const int place = bins.fragment_places[i];
      depths[place] = depth_from_bits((uint)(key >> 32));
      ids[place] = (uint)key;
    }
    head = head_before(bins.fragment_next, head);
  }
}

// What the tile's planes hold, block by block.
static inline void survey_blocks(Tile tile, Blocks* blocks) {
  Depth min_of[LANES], max_of[LANES];
  uint content[LANES];
  for (int block = 0; block < LANES; block++) {
    Depths low = NEAREST_DEPTH, high = FARTHEST_DEPTH;
    uint16 lowest_id = NO_ID;
    for (int y = 0; y < TILE_BLOCK; y++) {
      const int at = (row_of(block) + y) * ROW_VECTORS + column_of(block) / LANES;
      const Depths held = tile.depth[at];
      low = min(low, held);
      high = max(high, held);
      lowest_id = min(lowest_id, tile.id[at]);
    }
    min_of[block] = min_depth(low);
    max_of[block] = max_depth(high);
    content[block] = any_lane(lowest_id != NO_ID) ? PER_PIXEL : CLEAR;
  }
  blocks->min = vload16(0, min_of);
  blocks->max = vload16(0, max_of);
  blocks->content = vload16(0, content);
}

// ---- large triangles ------------------------------------------------------------------------------------------------

static inline void write_out_block(Tile tile, int column, int row, uint content, global const LargeTriangle* large,
                                   Depth background) {
  if (content == CLEAR) {
    for (int y = row; y < row + TILE_BLOCK; y++) {
      tile.depth[y * ROW_VECTORS + column / LANES] = background;
      tile.id[y * ROW_VECTORS + column / LANES] = NO_ID;
    }
    return;
  }
  global const LargeTriangle* t = &large[content];
  const TileDepth corner = depth_of_tile(t, tile.x, tile.y);
  for (int y = row; y < row + TILE_BLOCK; y++) {
    tile.depth[y * ROW_VECTORS + column / LANES] = depths_in_row(t, corner, column, y);
    tile.id[y * ROW_VECTORS + column / LANES] = t->id;
  }
}

// The columns and rows of the tile in which the triangle may cover samples.
typedef struct {
  int first_column, last_column, first_row, last_row;
} TileBox;

static inline TileBox box_of(global const LargeTriangle* t, Tile tile) {
  TileBox box;
  box.first_column = FIRST_PIXEL(t->ax + min(0, min(t->d1x, t->d2x))) - tile.x;
  box.last_column = LAST_PIXEL(t->ax + max(0, max(t->d1x, t->d2x))) - tile.x;
  box.first_row = FIRST_PIXEL(t->ay + min(0, min(t->d1y, t->d2y))) - tile.y;
  box.last_row = LAST_PIXEL(t->ay + max(0, max(t->d1y, t->d2y))) - tile.y;
  return box;
}

// A triangle's edges in the tile, in units of whole pixel steps: value at the first pixel and its change to the right
// and downwards; at least 0 inside. They fit 32 bits where the edge crosses the tile; where it does not, it is replaced
// by one that all samples pass.
typedef struct {
  int value[3], step_x[3], step_y[3];
} TileEdges;

static inline void find_covered_blocks(global const LargeTriangle* t, Tile tile, TileEdges* edges, int16* misses,
                                       int16* covers) {
  const int px = tile.x * SUBPIXELS + HALF_PIXEL, py = tile.y * SUBPIXELS + HALF_PIXEL;
  const int dx[3] = {t->d1x, t->d2x - t->d1x, -t->d2x}, dy[3] = {t->d1y, t->d2y - t->d1y, -t->d2y};
  const int vx[3] = {t->ax, t->ax + t->d1x, t->ax + t->d2x}, vy[3] = {t->ay, t->ay + t->d1y, t->ay + t->d2y};
  FOR_THREE(e) {
    const long exact = edge_value(dx[e], dy[e], vx[e], vy[e], px, py) >> SUBPIXEL_BITS;
    const int step_x = -dy[e], step_y = dx[e];
    if (exact + (min(0, step_x) + (long)min(0, step_y)) * (TILE - 1) >= 0) {
      edges->value[e] = edges->step_x[e] = edges->step_y[e] = 0;
      continue;
    }
    edges->value[e] = (int)exact;
    edges->step_x[e] = step_x;
    edges->step_y[e] = step_y;
    const int16 at = (int)exact + step_x * BLOCK_X + step_y * BLOCK_Y;
    *misses |= at + (max(0, step_x) + max(0, step_y)) * (TILE_BLOCK - 1) < 0;
    *covers &= at + (min(0, step_x) + min(0, step_y)) * (TILE_BLOCK - 1) >= 0;
  }
}

// Puts the triangle's samples in the rows first..last of 16 columns into the tile's planes: those in front of what is
// held or, without a depth test, all that it covers. Returns the least depth held there then.
ALWAYS_INLINE Depths draw_in_rows(Tile tile, const TileEdges* edges, global const LargeTriangle* t, TileDepth corner,
                                  int column, int first, int last, bool tests_depth) {
  int16 value[3];
  FOR_THREE(e) value[e] = edges->value[e] + edges->step_x[e] * (column + LANE) + edges->step_y[e] * first;
  const uint id = t->id;
  Depths min_held = NEAREST_DEPTH;
  for (int y = first; y <= last; y++) {
    const int at = y * ROW_VECTORS + column / LANES;
    const Depths depth = depths_in_row(t, corner, column, y), held = tile.depth[at];
    const uint16 held_id = tile.id[at];
    int16 wins = ((value[0] | value[1] | value[2]) >= 0) & in_range(t, corner, column, y);
    if (tests_depth) wins &= (depth > held) | ((depth == held) & (id < held_id));
    const Depths kept = select(held, depth, wins);
    tile.depth[at] = kept;
    tile.id[at] = select(held_id, (uint16)(id), as_uint16(wins));
    min_held = min(min_held, kept);
    FOR_THREE(e) value[e] += edges->step_y[e];
  }
  return min_held;
}

static inline void draw_in_blocks(Tile tile, Blocks* blocks, int16 partly, const TileEdges* edges,
                                  global const LargeTriangle* large, global const LargeTriangle* t, TileBox box,
                                  TileDepth corner, Depth background, bool tests_depth) {
  const Lanes content = lanes_of(blocks->content);
  FOR_EACH_LANE(block, partly) {
    const int column = column_of(block), row = row_of(block);
    if (content.lane[block] != PER_PIXEL) write_out_block(tile, column, row, content.lane[block], large, background);
    const int first = max(row, box.first_row), last = min(row + TILE_BLOCK - 1, box.last_row);
    if (first > last) continue;
    // Two loops, each without the question.
    const Depths held = tests_depth ? draw_in_rows(tile, edges, t, corner, column, first, last, true)
                                    : draw_in_rows(tile, edges, t, corner, column, first, last, false);
    if (last - first < TILE_BLOCK - 1) continue;  // rows that were left out may hold less
    blocks->min = max(blocks->min, select((Depths)(FARTHEST_DEPTH), (Depths)(min_depth(held)), LANE == block));
  }
  blocks->content = select(blocks->content, (uint16)(PER_PIXEL), as_uint16(partly));
}

static inline void merge_large_triangle(Tile tile, Blocks* blocks, global const LargeTriangle* large, uint entry,
                                        Depth background) {
  const uint number = entry & ~ENTIRE_TILE;
  global const LargeTriangle* t = &large[number];
  const TileDepth corner = depth_of_tile(t, tile.x, tile.y);
  // The part of each block that lies in the triangle's box, and the depths at its corners.
  const TileBox box = box_of(t, tile);
  const int16 left = max(BLOCK_X, (int16)(box.first_column)),
              right = min(BLOCK_X + (TILE_BLOCK - 1), (int16)(box.last_column));
  const int16 top = max(BLOCK_Y, (int16)(box.first_row)),
              bottom = min(BLOCK_Y + (TILE_BLOCK - 1), (int16)(box.last_row));
  const DepthBounds depth = depth_bounds(t, corner, left, right, top, bottom);
  int16 misses = (left > right) | (top > bottom) | (depth.max < blocks->min), covers = is_in_range(t) ? -1 : 0;
  if (!any_lane(~misses)) return;
  TileEdges edges;
  if (entry & ENTIRE_TILE)
    FOR_THREE(e) edges.value[e] = edges.step_x[e] = edges.step_y[e] = 0;
  else
    find_covered_blocks(t, tile, &edges, &misses, &covers);
  const int16 replaces = covers & ~misses & (depth.min > blocks->max);
  blocks->content = select(blocks->content, (uint16)(number), as_uint16(replaces));
  blocks->min = select(blocks->min, depth.min, replaces);
  blocks->max = select(blocks->max, depth.max, replaces);
  const int16 partly = ~misses & ~replaces;
  blocks->max = select(blocks->max, max(blocks->max, depth.max), partly);  // at most this
  if (any_lane(partly)) draw_in_blocks(tile, blocks, partly, &edges, large, t, box, corner, background, true);
}

static inline void place_large_triangle(Tile tile, Blocks* blocks, global const LargeTriangle* large, uint entry,
                                        Depth background) {
  const uint number = entry & ~ENTIRE_TILE;
  if (entry & ENTIRE_TILE) {
    blocks->content = number;
    return;
  }
  global const LargeTriangle* t = &large[number];
  int16 misses = 0, covers = -1;
  TileEdges edges;
  find_covered_blocks(t, tile, &edges, &misses, &covers);
  blocks->content = select(blocks->content, (uint16)(number), as_uint16(covers));
  const int16 partly = ~misses & ~covers;
  if (any_lane(partly))
    draw_in_blocks(tile, blocks, partly, &edges, large, t, box_of(t, tile), depth_of_tile(t, tile.x, tile.y),
                   background, false);
}

#endif
