// The samples of a tile where a pixel has one: planes of depths and ids, 16 pixels of a row in a vector. A part of
// tile.h.

#ifndef MORPHCL_PIXEL_PLANES_H
#define MORPHCL_PIXEL_PLANES_H

#define ROW_VECTORS (TILE / LANES)
#define TILE_VECTORS (TILE * ROW_VECTORS)

// ---- fragments ------------------------------------------------------------------------------------------------------

static inline void merge_fragments(Tile tile, ChunkBins bins, uint head) {
  TILE_MEMORY Depth* depths = (TILE_MEMORY Depth*)tile.depth;
  TILE_MEMORY uint* ids = (TILE_MEMORY uint*)tile.id;
  while (head) {
    for (uint i = first_of_page(head); i < head; i++) {
      const ulong key = bins.fragments[i];
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
      const ulong key = bins.fragments[i];
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

// The least and the greatest depth at the samples of boxes of pixels.
static inline DepthBounds depths_in_boxes(global const LargeTriangle* t, TileDepth origin, int16 left, int16 right,
                                          int16 top, int16 bottom) {
  return depth_bounds(t, origin, left, right, top, bottom);
}

static inline void write_out_block(Tile tile, int block, uint content, global const LargeTriangle* large,
                                   Depth background) {
  const int column = column_of(block), row = row_of(block);
  if (content == CLEAR) {
    for (int y = row; y < row + TILE_BLOCK; y++) {
      tile.depth[y * ROW_VECTORS + column / LANES] = background;
      tile.id[y * ROW_VECTORS + column / LANES] = NO_ID;
    }
    return;
  }
  global const LargeTriangle* t = &large[content];
  const TileDepth origin = depth_of_tile(t, tile.x, tile.y);
  const BlockColumns columns = block_columns(origin, column);
  for (int y = row; y < row + TILE_BLOCK; y++) {
    tile.depth[y * ROW_VECTORS + column / LANES] = depths_in_covered_row(t, origin, columns, y);
    tile.id[y * ROW_VECTORS + column / LANES] = t->id;
  }
}

// The least of the edges' functions at sixteen pixels of a row: at least 0 where they are covered.
ALWAYS_INLINE int16 min_edge_values(const TileEdges* edges, int column, int row) {
  int16 value[3];
  FOR_THREE(e) value[e] = edges->value[e] + edges->step_x[e] * (column + LANE) + edges->step_y[e] * row;
  return min(value[0], min(value[1], value[2]));
}
// Of those, what is covered and may be outside the corners.
ALWAYS_INLINE int16 beside_edges(const TileEdges* edges, int16 min_value) {
  return as_uint16(min_value) < (uint)edges->margin;
}

// Puts one row's pixels where the triangle `covers` into the tile's planes; returns the depths held there then.
ALWAYS_INLINE Depths draw_row(Tile tile, global const LargeTriangle* t, TileDepth origin, Depths depth, int16 covers,
                              int column, int row, bool tests_depth) {
  const int at = row * ROW_VECTORS + column / LANES;
  const uint id = t->id;
  const Depths held = tile.depth[at];
  const uint16 held_id = tile.id[at];
  int16 wins = covers & in_range(t, origin, column, row);
  if (tests_depth) wins &= (depth > held) | ((depth == held) & (id < held_id));
  const Depths kept = select(held, depth, wins);
  tile.depth[at] = kept;
  tile.id[at] = select(held_id, (uint16)(id), as_uint16(wins));
  return kept;
}

// The pixels that draw_in_rows() leaves: those beside edges, in the rows from `first` on that have a bit in some lane
// of `rows`. Returns the least depth held in first..last then.
static RARELY_CALLED Depths draw_beside_edges(Tile tile, const TileEdges* edges, global const LargeTriangle* t,
                                              TileDepth origin, int column, int first, int last, int16 rows,
                                              bool tests_depth) {
  const int8 halves = rows.lo | rows.hi;
  const int4 quarters = halves.lo | halves.hi;
  const int all = quarters.x | quarters.y | quarters.z | quarters.w;
  Depths min_held = NEAREST_DEPTH;
  for (int y = first; y <= last; y++) {
    if (all >> (y - first) & 1)
      draw_row(tile, t, origin, depths_beside_edges(t, origin, tile.x, tile.y, column, y),
               beside_edges(edges, min_edge_values(edges, column, y)), column, y, tests_depth);
    min_held = min(min_held, tile.depth[y * ROW_VECTORS + column / LANES]);
  }
  return min_held;
}

// Puts the triangle's samples in the rows first..last of a block into the tile's planes: those in front of what is
// held or, without a depth test, all that it covers. Returns the least depth held there then.
ALWAYS_INLINE Depths draw_in_rows(Tile tile, const TileEdges* edges, global const LargeTriangle* t, TileDepth origin,
                                  int block, int first, int last, bool tests_depth) {
  const int column = column_of(block);
  int16 value[3];
  FOR_THREE(e) value[e] = edges->value[e] + edges->step_x[e] * (column + LANE) + edges->step_y[e] * first;
  Depths min_held = NEAREST_DEPTH;
  int16 rows = 0;  // a bit a row: where some pixel is beside an edge
  for (int y = first; y <= last; y++) {
    const int16 min_value = min(value[0], min(value[1], value[2]));
    rows |= beside_edges(edges, min_value) & (1 << (y - first));
    min_held = min(min_held, draw_row(tile, t, origin, depths_in_row(t, origin, column, y), min_value >= edges->margin,
                                      column, y, tests_depth));
    FOR_THREE(e) value[e] += edges->step_y[e];
  }
  if (any_lane(rows != 0)) return draw_beside_edges(tile, edges, t, origin, column, first, last, rows, tests_depth);
  return min_held;
}

#endif
