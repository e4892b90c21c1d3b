#pragma OPENCL FP_CONTRACT OFF
// shade_tiles: what is visible at each pixel, its colour and its distance.
//
// In:  the chunks' bins, vertices, attributes, colours, face colours, clipped corners, draws, lights.
// Out: planes of half R, G, B, A (premultiplied) and float Z, rows of row_pitch elements;
//      blank_blocks[tile]: bit b set when block b of the tile holds the background, for the next frame to leave as it is.
// Steps for a tile: 1 clear; 2 merge fragments; 3 merge large triangles, 16 x 16 pixels at a time, where a triangle that
//   covers a block in front of all it holds replaces the block by a note (hierarchical depth); 4 shade each visible
//   sample once, 16 pixels of a row at a time, and store.
// A sample keeps the greatest depth, of equal ones the lowest id, so the order of merging does not matter. Where the plan
// proved that no sample is covered twice, samples are placed without being compared.
// One work-item draws a tile.

#include "layout.h"
#include "vector.h"
#include "raster.h"
#include "light.h"
#include "shade.h"

#define CLEAR NO_ID            // a block that nothing touched
#define PER_PIXEL (NO_ID - 1)  // a block whose samples stand in the tile's planes; else a block is one large triangle

// Samples of the tile, 16 of a row in a vector: rows of ROW_VECTORS vectors.
#define ROW_VECTORS (TILE / LANES)
typedef struct {
  local float16* depth;
  local uint16* id;
  int x, y;  // first pixel
} Tile;

// The 4 x 4 blocks of a tile, one a lane.
#define BLOCK_X ((int16)(0, 16, 32, 48, 0, 16, 32, 48, 0, 16, 32, 48, 0, 16, 32, 48))
#define BLOCK_Y ((int16)(0, 0, 0, 0, 16, 16, 16, 16, 32, 32, 32, 32, 48, 48, 48, 48))

typedef struct {
  uint16 content;        // CLEAR, PER_PIXEL or the index of a large triangle
  float16 least, greatest;  // depths in the block
} Blocks;

// ---- fragments ------------------------------------------------------------------------------------------------------

typedef struct {
  global const ulong* keys;
  global const ushort* places;
  global const uint* next;
} Fragments;

static inline void merge_fragments(Tile tile, Fragments fragments, uint head) {
  local float* depths = (local float*)tile.depth;
  local uint* ids = (local uint*)tile.id;
  while (head) {
    for (uint i = (head - 1) / PAGE * PAGE; i < head; i++) {
      const ulong key = fragments.keys[i];
      const float depth = as_float((uint)(key >> 32));
      const uint id = (uint)key;
      const int place = fragments.places[i];
      const float held = depths[place];
      if (depth > held || (depth == held && id < ids[place])) depths[place] = depth, ids[place] = id;
    }
    head = head_before(fragments.next, head);
  }
}

static inline void place_fragments(Tile tile, Fragments fragments, uint head) {
  local float* depths = (local float*)tile.depth;
  local uint* ids = (local uint*)tile.id;
  while (head) {
    for (uint i = (head - 1) / PAGE * PAGE; i < head; i++) {
      const ulong key = fragments.keys[i];
      const int place = fragments.places[i];
      depths[place] = as_float((uint)(key >> 32)), ids[place] = (uint)key;
    }
    head = head_before(fragments.next, head);
  }
}

// What the tile's planes hold, block by block.
static inline void survey_blocks(Tile tile, Blocks* blocks) {
  float least_of[LANES], greatest_of[LANES];
  uint content[LANES];
  for (int block = 0; block < LANES; block++) {
    float16 low = INFINITY, high = -INFINITY;
    uint16 lowest_id = NO_ID;
    for (int y = 0; y < TILE_BLOCK; y++) {
      const int at = ((block >> 2) * TILE_BLOCK + y) * ROW_VECTORS + (block & 3);
      const float16 held = tile.depth[at];
      low = min(low, held), high = max(high, held);
      lowest_id = min(lowest_id, tile.id[at]);
    }
    least_of[block] = least(low), greatest_of[block] = greatest(high);
    content[block] = any_lane(lowest_id != NO_ID) ? PER_PIXEL : CLEAR;
  }
  blocks->least = vload16(0, least_of), blocks->greatest = vload16(0, greatest_of);
  blocks->content = vload16(0, content);
}

// ---- large triangles ------------------------------------------------------------------------------------------------

// Depth of a large triangle in this tile is fma(depth_dx, column, fma(depth_dy, row, corner)), column and row counted from
// the tile's first pixel: rounding is monotone, so the extremes in a rectangle lie at its corners.
static inline float tile_depth(global const LargeTriangle* t, Tile tile) {
  return large_depth_at(*t, tile.x * SUBPIXELS + HALF_PIXEL, tile.y * SUBPIXELS + HALF_PIXEL);
}

static inline float16 depths_in_row(global const LargeTriangle* t, float corner, int column, int row) {
  return fma((float16)(t->depth_dx), convert_float16(LANE + column), (float16)(fma(t->depth_dy, (float)row, corner)));
}

static inline void write_out_block(Tile tile, int column, int row, uint content, global const LargeTriangle* large, float far_depth) {
  if (content == CLEAR) {
    for (int y = row; y < row + TILE_BLOCK; y++) {
      tile.depth[y * ROW_VECTORS + column / LANES] = far_depth;
      tile.id[y * ROW_VECTORS + column / LANES] = NO_ID;
    }
    return;
  }
  global const LargeTriangle* t = &large[content];
  const float corner = tile_depth(t, tile);
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

// A triangle's edges in the tile, in units of whole pixel steps: value at the first pixel and its change to the right and
// downwards; at least 0 inside. They fit 32 bits where the edge crosses the tile; where it does not, it is replaced by one
// that all samples pass.
typedef struct {
  int value[3], step_x[3], step_y[3];
} TileEdges;

static inline void find_covered_blocks(global const LargeTriangle* t, Tile tile, TileEdges* edges, int16* misses, int16* covers) {
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
    edges->value[e] = (int)exact, edges->step_x[e] = step_x, edges->step_y[e] = step_y;
    const int16 at = (int)exact + step_x * BLOCK_X + step_y * BLOCK_Y;
    *misses |= at + (max(0, step_x) + max(0, step_y)) * (TILE_BLOCK - 1) < 0;
    *covers &= at + (min(0, step_x) + min(0, step_y)) * (TILE_BLOCK - 1) >= 0;
  }
}

// Puts the triangle's samples in the rows first..last of 16 columns into the tile's planes: those in front of what is held
// or, without a depth test, all that it covers. Returns the least and the greatest depth held there then.
static inline float2 draw_in_rows(Tile tile, const TileEdges* edges, global const LargeTriangle* t, float corner, int column, int first,
                                  int last, bool tests_depth) {
  int16 value[3];
  FOR_THREE(e) value[e] = edges->value[e] + edges->step_x[e] * (column + LANE) + edges->step_y[e] * first;
  const uint id = t->id;
  float16 least_held = INFINITY, greatest_held = -INFINITY;
  for (int y = first; y <= last; y++) {
    const int at = y * ROW_VECTORS + column / LANES;
    const float16 depth = depths_in_row(t, corner, column, y), held = tile.depth[at];
    const uint16 held_id = tile.id[at];
    int16 wins = (value[0] | value[1] | value[2]) >= 0;
    if (tests_depth) wins &= (depth > held) | ((depth == held) & (id < held_id));
    const float16 kept = select(held, depth, wins);
    tile.depth[at] = kept;
    tile.id[at] = select(held_id, (uint16)(id), as_uint16(wins));
    least_held = min(least_held, kept), greatest_held = max(greatest_held, kept);
    FOR_THREE(e) value[e] += edges->step_y[e];
  }
  return (float2)(least(least_held), greatest(greatest_held));
}

static inline void draw_in_blocks(Tile tile, Blocks* blocks, int16 partly, const TileEdges* edges, global const LargeTriangle* large,
                                  global const LargeTriangle* t, TileBox box, float corner, float far_depth, bool tests_depth) {
  const Lanes content = lanes_of(blocks->content);
  FOR_EACH_LANE(block, partly) {
    const int column = (block & 3) * TILE_BLOCK, row = (block >> 2) * TILE_BLOCK;
    if (content.lane[block] != PER_PIXEL) write_out_block(tile, column, row, content.lane[block], large, far_depth);
    const int first = max(row, box.first_row), last = min(row + TILE_BLOCK - 1, box.last_row);
    if (first > last) continue;
    const float2 depths = draw_in_rows(tile, edges, t, corner, column, first, last, tests_depth);
    // Rows that were left out may hold less than these.
    const float least_depth = last - first == TILE_BLOCK - 1 ? depths.x : -INFINITY;
    blocks->least = max(blocks->least, select((float16)(-INFINITY), (float16)(least_depth), LANE == block));
    blocks->greatest = max(blocks->greatest, select((float16)(-INFINITY), (float16)(depths.y), LANE == block));
  }
  blocks->content = select(blocks->content, (uint16)(PER_PIXEL), as_uint16(partly));
}

static inline void merge_large_triangle(Tile tile, Blocks* blocks, global const LargeTriangle* large, uint entry, float far_depth) {
  const uint number = entry & ~ENTIRE_TILE;
  global const LargeTriangle* t = &large[number];
  const float corner = tile_depth(t, tile), depth_dx = t->depth_dx, depth_dy = t->depth_dy;
  // The part of each block that lies in the triangle's box, and the depths at its corners.
  const TileBox box = box_of(t, tile);
  const int16 left = max(BLOCK_X, (int16)(box.first_column)), right = min(BLOCK_X + (TILE_BLOCK - 1), (int16)(box.last_column));
  const int16 top = max(BLOCK_Y, (int16)(box.first_row)), bottom = min(BLOCK_Y + (TILE_BLOCK - 1), (int16)(box.last_row));
  const int16 falls_x = depth_dx < 0.0f ? (int16)(-1) : (int16)(0), falls_y = depth_dy < 0.0f ? (int16)(-1) : (int16)(0);
  const float16 farthest_x = convert_float16(select(left, right, falls_x)), nearest_x = convert_float16(select(right, left, falls_x));
  const float16 farthest_y = convert_float16(select(top, bottom, falls_y)), nearest_y = convert_float16(select(bottom, top, falls_y));
  const float16 least_depth = fma((float16)(depth_dx), farthest_x, fma((float16)(depth_dy), farthest_y, (float16)(corner)));
  const float16 greatest_depth = fma((float16)(depth_dx), nearest_x, fma((float16)(depth_dy), nearest_y, (float16)(corner)));
  int16 misses = (left > right) | (top > bottom) | (greatest_depth < blocks->least), covers = -1;
  if (!any_lane(~misses)) return;
  TileEdges edges;
  if (entry & ENTIRE_TILE)
    FOR_THREE(e) edges.value[e] = edges.step_x[e] = edges.step_y[e] = 0;
  else
    find_covered_blocks(t, tile, &edges, &misses, &covers);
  const int16 replaces = covers & ~misses & (least_depth > blocks->greatest);
  blocks->content = select(blocks->content, (uint16)(number), as_uint16(replaces));
  blocks->least = select(blocks->least, least_depth, replaces);
  blocks->greatest = select(blocks->greatest, greatest_depth, replaces);
  const int16 partly = ~misses & ~replaces;
  if (any_lane(partly)) draw_in_blocks(tile, blocks, partly, &edges, large, t, box, corner, far_depth, true);
}

static inline void place_large_triangle(Tile tile, Blocks* blocks, global const LargeTriangle* large, uint entry, float far_depth) {
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
  if (any_lane(partly)) draw_in_blocks(tile, blocks, partly, &edges, large, t, box_of(t, tile), tile_depth(t, tile), far_depth, false);
}

// ---- pixels ---------------------------------------------------------------------------------------------------------

typedef struct {
  global half *red, *green, *blue, *alpha;
  global float* distance;
} Picture;

// Sixteen halves, rounded to nearest even. Where the processor converts a whole vector it is asked to: vstore_half16 goes
// by halves of vectors.
ALWAYS_INLINE ushort16 to_halves(float16 value) {
#if defined(MORPHCL_POCL) && defined(__AVX512F__)
  typedef _Float16 Halves __attribute__((ext_vector_type(16)));
  return __builtin_astype(__builtin_convertvector(value, Halves), ushort16);
#else
  ushort bits[LANES];
  vstore_half16(value, 0, (private half*)bits);
  return vload16(0, bits);
#endif
}

// Colour and alpha of 16 pixels of a row.
typedef struct {
  ushort16 red, green, blue, alpha;
} RowColor;

ALWAYS_INLINE RowColor row_color(Irradiance color, float16 alpha) {
  RowColor halves;
  halves.red = to_halves(color.r), halves.green = to_halves(color.g), halves.blue = to_halves(color.b);
  halves.alpha = to_halves(alpha);
  return halves;
}

// Two neighbours at a time: what goes past the cache should fill its lines, of 64 bytes on most processors.
ALWAYS_INLINE void store_line(ushort16 left, ushort16 right, global half* out) {
  STORE_PAST_CACHE((ulong8)(as_ulong4(left), as_ulong4(right)), (global ulong8*)out);
}

ALWAYS_INLINE void store_colors(RowColor left, RowColor right, Picture picture, size_t at) {
  store_line(left.red, right.red, picture.red + at);
  store_line(left.green, right.green, picture.green + at);
  store_line(left.blue, right.blue, picture.blue + at);
  store_line(left.alpha, right.alpha, picture.alpha + at);
}

// Sixteen columns of the rows of blocks that are shaded together. The surface is kept while its id stays.
typedef struct {
  uint content;
  global const LargeTriangle* triangle;  // a block of one triangle
  float corner;                          // its depth at the tile's first pixel
  uint surface_id;                       // NO_ID: the surface is still to be gathered
  Surface surface;
} Column;

ALWAYS_INLINE void start_block(Column* column, Tile tile, uint content, global const LargeTriangle* large) {
  column->content = content;
  if (content == CLEAR || content == PER_PIXEL) return;
  column->triangle = &large[content];
  column->corner = tile_depth(column->triangle, tile);
}

ALWAYS_INLINE Irradiance color_of_primitive(const Shader* s, Column* column, uint id, Pixels p) {
  if (column->surface_id != id) {
    gather_surface(s, draw_of(s, id), lanes_of(id), true, &column->surface);
    column->surface_id = id;
  }
  return surface_color(s, &column->surface, p);
}

// One row of a block: stores its distances and returns its colours.
ALWAYS_INLINE RowColor shade_row_of_block(const Shader* s, Column* column, Tile tile, int first, int row, Picture picture) {
  Pixels p;
  p.x = tile.x + first, p.y = tile.y + row;
  Irradiance color;
  color.r = color.g = color.b = 0.0f;
  float16 alpha = 0.0f, distance = BACKGROUND_DEPTH;
  if (column->content == PER_PIXEL) {
    const uint16 ids = tile.id[row * ROW_VECTORS + first / LANES];
    const uint first_id = ids.s0;
    p.depth = tile.depth[row * ROW_VECTORS + first / LANES];
    if (any_lane(ids != first_id)) {
      const int16 background = ids == NO_ID;
      if (s->frame->writes_color) color = mixed_color(s, p, ids);
      alpha = select((float16)1.0f, (float16)0.0f, background);
      distance = select(eye_distance(s->frame, p.depth), (float16)BACKGROUND_DEPTH, background);
    } else if (first_id != NO_ID) {
      if (s->frame->writes_color) color = color_of_primitive(s, column, first_id, p);
      alpha = 1.0f, distance = eye_distance(s->frame, p.depth);
    }
  } else if (column->content != CLEAR) {
    p.depth = depths_in_row(column->triangle, column->corner, first, row);
    if (s->frame->writes_color) color = color_of_primitive(s, column, column->triangle->id, p);
    alpha = 1.0f, distance = eye_distance(s->frame, p.depth);
  }
  if (s->frame->writes_depth)
    STORE_PAST_CACHE(distance, (global float16*)(picture.distance + (size_t)p.y * s->frame->row_pitch + p.x));
  return row_color(color, alpha);
}

COMPILED_ONCE void shade_tile(uint place, constant const FrameConstants* restrict frame,
                              global const DrawConstants* restrict draws, global const uint* restrict block_draw,
                              global const uint* restrict indices, global const LightConstants* restrict lights,
                              global const int4* restrict vertices, global const int4* restrict attributes,
                              global const int4* restrict colors, global const int4* restrict face_color,
                              global const uint* restrict clip_source, global const float4* restrict clip_weights,
                              global const ChunkStatus* restrict status, global const uint* restrict fragment_heads,
                              global const uint* restrict fragment_next, global const ulong* restrict fragment_keys,
                              global const ushort* restrict fragment_places, global const uint* restrict entry_heads,
                              global const uint* restrict entry_next, global const uint* restrict entry_triangles,
                              global const LargeTriangle* restrict large, global const uint* restrict overflow,
                              global half* restrict red, global half* restrict green, global half* restrict blue,
                              global half* restrict alpha, global float* restrict distance,
                              global uint* restrict blank_blocks, local float16* tile_depths, local uint16* tile_ids) {
  if (*overflow) return;  // the bins are incomplete: the host makes room and starts again
  const uint tiles = (uint)(frame->tiles_x * frame->tiles_y), chunks = frame->chunk_count;
  const uint number = (place * frame->tile_step) % tiles;
  Tile tile;
  tile.depth = tile_depths, tile.id = tile_ids;
  tile.x = (int)(number % (uint)frame->tiles_x) * TILE, tile.y = (int)(number / (uint)frame->tiles_x) * TILE;

  // ---- 1, 2
  Blocks blocks;
  blocks.content = CLEAR;
  blocks.least = blocks.greatest = frame->far_depth;
  bool any_fragment = false, any_entry = false;
  for (uint chunk = 0; chunk < chunks; chunk++) {
    any_fragment |= fragment_heads[(size_t)chunk * tiles + number] != 0;
    any_entry |= entry_heads[(size_t)chunk * tiles + number] != 0;
  }
  if (any_fragment) {
    for (int i = 0; i < TILE * ROW_VECTORS; i++) tile.depth[i] = frame->far_depth, tile.id[i] = NO_ID;
    for (uint chunk = 0; chunk < chunks; chunk++) {
      const size_t first_page = (size_t)chunk * frame->fragment_pages;
      const Fragments fragments = {fragment_keys + first_page * PAGE, fragment_places + first_page * PAGE, fragment_next + first_page};
      const uint head = fragment_heads[(size_t)chunk * tiles + number];
      if (frame->tests_depth)
        merge_fragments(tile, fragments, head);
      else
        place_fragments(tile, fragments, head);
    }
    survey_blocks(tile, &blocks);
  }

  // ---- 3
  if (any_entry)
    for (uint chunk = 0; chunk < chunks; chunk++) {
      global const uint* entries = entry_triangles + (size_t)chunk * frame->entry_pages * PAGE;
      global const uint* next = entry_next + (size_t)chunk * frame->entry_pages;
      for (uint head = entry_heads[(size_t)chunk * tiles + number]; head; head = head_before(next, head))
        for (uint i = (head - 1) / PAGE * PAGE; i < head; i++)
          if (frame->tests_depth)
            merge_large_triangle(tile, &blocks, large, chunk * frame->large_capacity + entries[i], frame->far_depth);
          else
            place_large_triangle(tile, &blocks, large, chunk * frame->large_capacity + entries[i], frame->far_depth);
    }

  // ---- 4
  const Lanes content = lanes_of(blocks.content);
  uint blank = 0;
  for (int block = 0; block < LANES; block++) blank |= content.lane[block] == CLEAR ? 1u << block : 0u;
  uint left_as_it_is = frame->keeps_blank_tiles ? blank & blank_blocks[number] : 0u;
  left_as_it_is &= left_as_it_is >> 1;  // bits of even blocks: both of the pair
  blank_blocks[number] = blank;

  Shader shader;
  shader.frame = frame, shader.draws = draws, shader.block_draw = block_draw, shader.indices = indices, shader.lights = lights;
  shader.vertices = vertices, shader.attributes = attributes, shader.colors = colors, shader.face_color = face_color;
  shader.clip_source = clip_source, shader.clip_weights = clip_weights;
  shader.clipped = 0;
  if (frame->clips)
    for (uint chunk = 0; chunk < chunks; chunk++) shader.clipped += status[chunk].clipped;
  const Picture picture = {red, green, blue, alpha, distance};
  Column columns[TILE / TILE_BLOCK];
  for (int i = 0; i < TILE / TILE_BLOCK; i++) columns[i].surface_id = NO_ID;

  RowColor left;
  left.red = left.green = left.blue = left.alpha = 0;
  const int rows = min(TILE, frame->height - tile.y);
  for (int first_row = 0; first_row < rows; first_row += TILE_BLOCK) {
    const int first_block = first_row / TILE_BLOCK * (TILE / TILE_BLOCK);
    for (int i = 0; i < TILE / TILE_BLOCK; i++) start_block(&columns[i], tile, content.lane[first_block + i], large);
    for (int row = first_row; row < min(first_row + TILE_BLOCK, rows); row++)
      for (int i = 0; i < TILE / TILE_BLOCK; i++) {
        if (left_as_it_is >> (first_block + (i & ~1)) & 1u) continue;
        const RowColor color = shade_row_of_block(&shader, &columns[i], tile, i * TILE_BLOCK, row, picture);
        if (i & 1 && frame->writes_color)
          store_colors(left, color, picture, (size_t)(tile.y + row) * frame->row_pitch + tile.x + (i - 1) * TILE_BLOCK);
        left = color;
      }
  }
}

kernel void shade_tiles(constant const FrameConstants* frame, global const DrawConstants* draws,
                        global const uint* block_draw, global const uint* indices, global const LightConstants* lights,
                        global const int4* vertices, global const int4* attributes, global const int4* colors,
                        global const int4* face_color, global const uint* clip_source,
                        global const float4* clip_weights, global const ChunkStatus* status,
                        global const uint* fragment_heads, global const uint* fragment_next,
                        global const ulong* fragment_keys, global const ushort* fragment_places,
                        global const uint* entry_heads, global const uint* entry_next,
                        global const uint* entry_triangles, global const LargeTriangle* large,
                        global const uint* overflow, global half* red, global half* green, global half* blue,
                        global half* alpha, global float* distance, global uint* blank_blocks,
                        local float16* tile_depths, local uint16* tile_ids) {
  shade_tile((uint)get_global_id(0), frame, draws, block_draw, indices, lights, vertices, attributes, colors,
             face_color, clip_source, clip_weights, status, fragment_heads, fragment_next, fragment_keys,
             fragment_places, entry_heads, entry_next, entry_triangles, large, overflow, red, green, blue, alpha,
             distance, blank_blocks, tile_depths, tile_ids);
}
