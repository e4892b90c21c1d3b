// What is visible in a tile of 64 x 64 pixels: for each sample depth and id, kept block by block (16 x 16 pixels).
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
// Several samples a pixel are more than local memory holds elsewhere.
#if defined(MORPHCL_POCL) || SAMPLES > 1
#define TILE_MEMORY private
#else
#define TILE_MEMORY local
#endif

// Samples of the tile, as sample_planes.h or pixel_planes.h have them.
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

#if SAMPLES > 1
// Vectors of samples hold all those of some pixels side by side.
#define VECTOR_PIXELS (LANES / SAMPLES)
#if SAMPLES == 2
#define OF_LANES(list) (int16)(list, list, list, list, list, list, list, list)
#elif SAMPLES == 4
#define OF_LANES(list) (int16)(list, list, list, list)
#elif SAMPLES == 8
#define OF_LANES(list) (int16)(list, list)
#else
#define OF_LANES(list) (int16)(list)
#endif
#define SAMPLE_X_OF_LANES OF_LANES(SAMPLES_X)  // in units of SAMPLE_UNIT
#define SAMPLE_Y_OF_LANES OF_LANES(SAMPLES_Y)
#endif

// ---- large triangles ------------------------------------------------------------------------------------------------

// The columns and rows of the tile in which the triangle may cover samples.
typedef struct {
  int first_column, last_column, first_row, last_row;
} TileBox;

static inline TileBox box_of(global const LargeTriangle* t, Tile tile) {
  TileBox box;
  box.first_column = FIRST_PIXEL(SUBPIXEL_OF(min(t->x[0], min(t->x[1], t->x[2])))) - tile.x;
  box.last_column = LAST_PIXEL(SUBPIXEL_OF(max(t->x[0], max(t->x[1], t->x[2])))) - tile.x;
  box.first_row = FIRST_PIXEL(SUBPIXEL_OF(min(t->y[0], min(t->y[1], t->y[2])))) - tile.y;
  box.last_row = LAST_PIXEL(SUBPIXEL_OF(max(t->y[0], max(t->y[1], t->y[2])))) - tile.y;
  return box;
}

// A triangle's edges in the tile, in units of whole pixel steps: value at the first pixel (its FIRST_SAMPLE) and its
// change to the right and downwards; at least 0 inside. They fit 32 bits where the edge crosses the tile; where it does
// not, it is replaced by one that all samples pass.
typedef struct {
  int value[3], step_x[3], step_y[3];
#if SAMPLES == 1
  int margin;  // margin_of_edges() in these units
#else
  int16 to_sample[3];  // in vectors of samples (sample_planes.h): from the first sample of a pixel, along both axes
#endif
} TileEdges;

static inline void pass_all_samples(TileEdges* edges, int e) {
  edges->value[e] = NO_MARGIN;
  edges->step_x[e] = edges->step_y[e] = 0;
#if SAMPLES > 1
  edges->to_sample[e] = 0;
#endif
}

static inline void pass_all_edges(TileEdges* edges) {
  FOR_THREE(e) pass_all_samples(edges, e);
#if SAMPLES == 1
  edges->margin = 0;
#endif
}

static inline void find_covered_blocks(global const LargeTriangle* t, Tile tile, TileEdges* edges, int16* misses,
                                       int16* covers) {
  const int px = tile.x * SUBPIXELS + FIRST_SAMPLE, py = tile.y * SUBPIXELS + FIRST_SAMPLE;
  const int vx[3] = {SUBPIXEL_OF(t->x[0]), SUBPIXEL_OF(t->x[1]), SUBPIXEL_OF(t->x[2])},
            vy[3] = {SUBPIXEL_OF(t->y[0]), SUBPIXEL_OF(t->y[1]), SUBPIXEL_OF(t->y[2])};
  const int dx[3] = {vx[1] - vx[0], vx[2] - vx[1], vx[0] - vx[2]},
            dy[3] = {vy[1] - vy[0], vy[2] - vy[1], vy[0] - vy[2]};
  const int margin = margin_in_tile(t);
#if SAMPLES == 1
  edges->margin = margin;
#endif
  FOR_THREE(e) {
    const long value = edge_value(dx[e], dy[e], vx[e], vy[e], px, py), exact = value >> SUBPIXEL_BITS;
    const int step_x = -dy[e], step_y = dx[e];
    const long falls = min(0, step_x) + (long)min(0, step_y), rises = max(0, step_x) + (long)max(0, step_y);
    // Between a pixel's samples, rounded outwards; 0 for a single one.
    const int falls_in_pixel = (int)(falls * (LAST_SAMPLE - FIRST_SAMPLE) >> SUBPIXEL_BITS),
              rises_in_pixel = -(int)(-rises * (LAST_SAMPLE - FIRST_SAMPLE) >> SUBPIXEL_BITS);
    if (exact + falls * (TILE - 1) + falls_in_pixel >= margin) {
      pass_all_samples(edges, e);
      continue;
    }
    edges->value[e] = (int)exact;
    edges->step_x[e] = step_x;
    edges->step_y[e] = step_y;
#if SAMPLES > 1
    // (value + steps) >> SUBPIXEL_BITS less exact; steps are multiples of SAMPLE_UNIT.
    const int rest = (int)(value & (SUBPIXELS - 1)) >> SAMPLE_UNIT_BITS;
    const int16 steps =
        (SAMPLE_X_OF_LANES - MIN_SAMPLE(SAMPLES)) * step_x + (SAMPLE_Y_OF_LANES - MIN_SAMPLE(SAMPLES)) * step_y;
    edges->to_sample[e] = (steps + rest) >> (SUBPIXEL_BITS - SAMPLE_UNIT_BITS);
#endif
    const int16 at = (int)exact + step_x * BLOCK_X + step_y * BLOCK_Y;
    *misses |= at + ((int)rises * (TILE_BLOCK - 1) + rises_in_pixel) < 0;
    *covers &= at + ((int)falls * (TILE_BLOCK - 1) + falls_in_pixel) >= margin;
  }
}

#if SAMPLES == 1
#include "pixel_planes.h"
#else
#include "sample_planes.h"
#endif

static inline void draw_in_blocks(Tile tile, Blocks* blocks, int16 partly, const TileEdges* edges,
                                  global const LargeTriangle* large, global const LargeTriangle* t, TileBox box,
                                  TileDepth origin, Depth background, bool tests_depth) {
  const Lanes content = lanes_of(blocks->content);
  FOR_EACH_LANE(block, partly) {
    const int row = row_of(block);
    if (content.lane[block] != PER_PIXEL) write_out_block(tile, block, content.lane[block], large, background);
    const int first = max(row, box.first_row), last = min(row + TILE_BLOCK - 1, box.last_row);
    if (first > last) continue;
    // Two loops, each without the question.
    const Depths held = tests_depth ? draw_in_rows(tile, edges, t, origin, block, first, last, true)
                                    : draw_in_rows(tile, edges, t, origin, block, first, last, false);
    if (last - first < TILE_BLOCK - 1) continue;  // rows that were left out may hold less
    blocks->min = max(blocks->min, select((Depths)(FARTHEST_DEPTH), (Depths)(min_depth(held)), LANE == block));
  }
  blocks->content = select(blocks->content, (uint16)(PER_PIXEL), as_uint16(partly));
}

static inline void merge_large_triangle(Tile tile, Blocks* blocks, global const LargeTriangle* large, uint entry,
                                        Depth background) {
  const uint number = entry & ~ENTIRE_TILE;
  global const LargeTriangle* t = &large[number];
  const TileDepth origin = depth_of_tile(t, tile.x, tile.y);
  // The part of each block that lies in the triangle's box, and the depths at its corners.
  const TileBox box = box_of(t, tile);
  const int16 left = max(BLOCK_X, (int16)(box.first_column)),
              right = min(BLOCK_X + (TILE_BLOCK - 1), (int16)(box.last_column));
  const int16 top = max(BLOCK_Y, (int16)(box.first_row)),
              bottom = min(BLOCK_Y + (TILE_BLOCK - 1), (int16)(box.last_row));
  const DepthBounds depth = depths_in_boxes(t, origin, left, right, top, bottom);
  int16 misses = (left > right) | (top > bottom) | (depth.max < blocks->min), covers = is_in_range(t) ? -1 : 0;
#if SAMPLES == 1
  covers &= bounds_are_within_corners(t, depth);
#endif
  if (!any_lane(~misses)) return;
  TileEdges edges;
  if (entry & ENTIRE_TILE)
    pass_all_edges(&edges);
  else
    find_covered_blocks(t, tile, &edges, &misses, &covers);
  const int16 replaces = covers & ~misses & (depth.min > blocks->max);
  blocks->content = select(blocks->content, (uint16)(number), as_uint16(replaces));
  blocks->min = select(blocks->min, depth.min, replaces);
  blocks->max = select(blocks->max, depth.max, replaces);
  const int16 partly = ~misses & ~replaces;
  blocks->max = select(blocks->max, max(blocks->max, depth.max), partly);  // at most this
  if (any_lane(partly)) draw_in_blocks(tile, blocks, partly, &edges, large, t, box, origin, background, true);
}

static inline void place_large_triangle(Tile tile, Blocks* blocks, global const LargeTriangle* large, uint entry,
                                        Depth background) {
  const uint number = entry & ~ENTIRE_TILE;
  global const LargeTriangle* t = &large[number];
  const TileDepth origin = depth_of_tile(t, tile.x, tile.y);
  int16 misses = 0, covers = -1;
#if SAMPLES == 1
  covers = bounds_are_within_corners(
      t, depths_in_boxes(t, origin, BLOCK_X, BLOCK_X + (TILE_BLOCK - 1), BLOCK_Y, BLOCK_Y + (TILE_BLOCK - 1)));
#endif
  TileEdges edges;
  if (entry & ENTIRE_TILE)
    pass_all_edges(&edges);
  else
    find_covered_blocks(t, tile, &edges, &misses, &covers);
  covers &= ~misses;
  blocks->content = select(blocks->content, (uint16)(number), as_uint16(covers));
  const int16 partly = ~misses & ~covers;
  if (any_lane(partly))
    draw_in_blocks(tile, blocks, partly, &edges, large, t, box_of(t, tile), origin, background, false);
}

#endif
