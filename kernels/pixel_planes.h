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
static inline DepthBounds depths_in_boxes(global const LargeTriangle* t, TileDepth corner, int16 left, int16 right,
                                          int16 top, int16 bottom) {
  return depth_bounds(t, corner, left, right, top, bottom);
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
  const TileDepth corner = depth_of_tile(t, tile.x, tile.y);
  for (int y = row; y < row + TILE_BLOCK; y++) {
    tile.depth[y * ROW_VECTORS + column / LANES] = depths_in_row(t, corner, column, y);
    tile.id[y * ROW_VECTORS + column / LANES] = t->id;
  }
}

// Puts the triangle's samples in the rows first..last of a block into the tile's planes: those in front of what is
// held or, without a depth test, all that it covers. Returns the least depth held there then.
ALWAYS_INLINE Depths draw_in_rows(Tile tile, const TileEdges* edges, global const LargeTriangle* t, TileDepth corner,
                                  int block, int first, int last, bool tests_depth) {
  const int column = column_of(block);
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

#endif
