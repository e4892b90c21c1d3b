#pragma OPENCL FP_CONTRACT OFF
// shade_tiles: what is visible at each pixel, its colour and its distance.
//
// In:  the chunks' bins, vertices, attributes, colours, face light, clipped corners, draws, blocks, lights.
// Out: planes of half R, G, B, A (premultiplied) and float Z, rows of row_pitch elements.
// Steps for a tile: 1 clear; 2 merge fragments; 3 merge large triangles, 16 x 16 pixels at a time, where a triangle that
//   covers a block in front of all it holds replaces the block by a note (hierarchical depth); 4 shade each visible
//   sample once, 16 pixels of a row at a time, and store.
// A sample keeps the greatest depth, of equal ones the lowest id, so the order of merging does not matter.
// One work-item draws a tile.

#include "layout.h"
#include "vector.h"
#include "raster.h"
#include "light.h"
#include "shade.h"

#define CLEAR NO_ID          // a block that nothing touched
#define PER_PIXEL (NO_ID - 1)  // a block whose samples stand in the tile's planes; else a block is one large triangle

typedef struct {
  local float* depth;  // 64 x 64
  local uint* id;
  int x, y;            // first pixel
} Tile;

// The 4 x 4 blocks of a tile, one a lane.
#define BLOCK_X ((int16)(0, 16, 32, 48, 0, 16, 32, 48, 0, 16, 32, 48, 0, 16, 32, 48))
#define BLOCK_Y ((int16)(0, 0, 0, 0, 16, 16, 16, 16, 32, 32, 32, 32, 48, 48, 48, 48))

typedef struct {
  uint16 content;        // CLEAR, PER_PIXEL or the index of a large triangle
  float16 least, greatest;  // depths in the block
} Blocks;

static inline void merge_fragments(Tile tile, global const ulong* keys, global const ushort* places,
                                   global const uint* next, uint head) {
  while (head) {
    const uint page = (head - 1) / PAGE, count = head - page * PAGE;
    for (uint i = page * PAGE; i < page * PAGE + count; i++) {
      const ulong key = keys[i];
      const float depth = as_float((uint)(key >> 32));
      const uint id = (uint)key;
      const int place = places[i];
      const float held = tile.depth[place];
      if (depth > held || (depth == held && id < tile.id[place])) tile.depth[place] = depth, tile.id[place] = id;
    }
    head = next[page] ? (next[page] + 1) * PAGE : 0;
  }
}

// Depth of a large triangle in this tile is fma(depth_dx, column, fma(depth_dy, row, corner)), column and row counted from
// the tile's first pixel: rounding is monotone, so a block's extremes lie at its corners.
static inline float tile_depth(global const LargeTriangle* t, Tile tile) {
  return large_depth_at(*t, tile.x * SUBPIXELS + HALF_PIXEL, tile.y * SUBPIXELS + HALF_PIXEL);
}

static inline void write_out_block(Tile tile, int column, int row, uint content, global const LargeTriangle* large, float far_depth) {
  if (content == CLEAR) {
    for (int y = row; y < row + TILE_BLOCK; y++) {
      vstore16((float16)(far_depth), 0, tile.depth + y * TILE + column);
      vstore16((uint16)(NO_ID), 0, tile.id + y * TILE + column);
    }
    return;
  }
  global const LargeTriangle* t = &large[content];
  const float corner = tile_depth(t, tile);
  const float16 columns = convert_float16(LANE + column);
  for (int y = row; y < row + TILE_BLOCK; y++) {
    vstore16(fma((float16)(t->depth_dx), columns, (float16)(fma(t->depth_dy, (float)y, corner))), 0, tile.depth + y * TILE + column);
    vstore16((uint16)(t->id), 0, tile.id + y * TILE + column);
  }
}

static inline void merge_large_triangle(Tile tile, Blocks* blocks, global const LargeTriangle* large, uint number, float far_depth) {
  global const LargeTriangle* t = &large[number];
  const int px = tile.x * SUBPIXELS + HALF_PIXEL, py = tile.y * SUBPIXELS + HALF_PIXEL;
  const int dx[3] = {t->d1x, t->d2x - t->d1x, -t->d2x}, dy[3] = {t->d1y, t->d2y - t->d1y, -t->d2y};
  const int vx[3] = {t->ax, t->ax + t->d1x, t->ax + t->d2x}, vy[3] = {t->ay, t->ay + t->d1y, t->ay + t->d2y};
  // Edge values in units of whole pixel steps fit 32 bits where the edge crosses the tile; where it does not, it is
  // replaced by one that all samples pass.
  int value[3], step_x[3], step_y[3];
  int16 misses = 0, covers = -1;
  for (int e = 0; e < 3; e++) {
    const long exact = edge_value(dx[e], dy[e], vx[e], vy[e], px, py) >> SUBPIXEL_BITS;
    step_x[e] = -dy[e], step_y[e] = dx[e];
    if (exact + (min(0, step_x[e]) + (long)min(0, step_y[e])) * (TILE - 1) >= 0) {
      value[e] = step_x[e] = step_y[e] = 0;
      continue;
    }
    value[e] = (int)exact;
    const int16 at = value[e] + step_x[e] * BLOCK_X + step_y[e] * BLOCK_Y;
    misses |= at + (max(0, step_x[e]) + max(0, step_y[e])) * (TILE_BLOCK - 1) < 0;
    covers &= at + (min(0, step_x[e]) + min(0, step_y[e])) * (TILE_BLOCK - 1) >= 0;
  }
  const float corner = tile_depth(t, tile), depth_dx = t->depth_dx, depth_dy = t->depth_dy;
  const uint id = t->id;
  const float16 left = convert_float16(BLOCK_X + (depth_dx < 0.0f ? TILE_BLOCK - 1 : 0));
  const float16 right = convert_float16(BLOCK_X + (depth_dx < 0.0f ? 0 : TILE_BLOCK - 1));
  const float16 top = convert_float16(BLOCK_Y + (depth_dy < 0.0f ? TILE_BLOCK - 1 : 0));
  const float16 bottom = convert_float16(BLOCK_Y + (depth_dy < 0.0f ? 0 : TILE_BLOCK - 1));
  const float16 least_depth = fma((float16)(depth_dx), left, fma((float16)(depth_dy), top, (float16)(corner)));
  const float16 greatest_depth = fma((float16)(depth_dx), right, fma((float16)(depth_dy), bottom, (float16)(corner)));
  misses |= greatest_depth < blocks->least;
  const int16 replaces = covers & ~misses & (least_depth > blocks->greatest);
  blocks->content = select(blocks->content, (uint16)(number), as_uint16(replaces));
  blocks->least = select(blocks->least, least_depth, replaces);
  blocks->greatest = select(blocks->greatest, greatest_depth, replaces);

  const int16 partly = ~misses & ~replaces;
  if (!any_lane(partly)) return;
  uint content[LANES];
  float least_of[LANES], greatest_of[LANES];
  vstore16(blocks->content, 0, content);
  vstore16(blocks->least, 0, least_of);
  vstore16(blocks->greatest, 0, greatest_of);
  const ulong2 lanes = mask_bytes(partly);
  for (int half_of = 0; half_of < 2; half_of++)
    for (ulong bytes = half_of ? lanes.y : lanes.x; bytes;) {
      const int in_half = lowest_lane(bytes), block = in_half + half_of * 8;
      bytes = without_lane(bytes, in_half);
      const int column = (block & 3) * TILE_BLOCK, row = (block >> 2) * TILE_BLOCK;
      if (content[block] != PER_PIXEL) write_out_block(tile, column, row, content[block], large, far_depth);
      content[block] = PER_PIXEL;
      int16 value0 = value[0] + step_x[0] * (column + LANE) + step_y[0] * row;
      int16 value1 = value[1] + step_x[1] * (column + LANE) + step_y[1] * row;
      int16 value2 = value[2] + step_x[2] * (column + LANE) + step_y[2] * row;
      const float16 columns = convert_float16(LANE + column);
      float16 least_held = INFINITY, greatest_held = -INFINITY;
      for (int y = row; y < row + TILE_BLOCK; y++) {
        local float* depths = tile.depth + y * TILE + column;
        local uint* ids = tile.id + y * TILE + column;
        const float16 depth = fma((float16)(depth_dx), columns, (float16)(fma(depth_dy, (float)y, corner)));
        const float16 held = vload16(0, depths);
        const uint16 held_id = vload16(0, ids);
        const int16 wins = ((value0 | value1 | value2) >= 0) & ((depth > held) | ((depth == held) & (id < held_id)));
        const float16 kept = select(held, depth, wins);
        vstore16(kept, 0, depths);
        vstore16(select(held_id, (uint16)(id), as_uint16(wins)), 0, ids);
        least_held = min(least_held, kept);
        greatest_held = max(greatest_held, kept);
        value0 += step_y[0], value1 += step_y[1], value2 += step_y[2];
      }
      least_of[block] = least(least_held);
      greatest_of[block] = greatest(greatest_held);
    }
  blocks->content = vload16(0, content);
  blocks->least = vload16(0, least_of);
  blocks->greatest = vload16(0, greatest_of);
}

static inline void store_half(float16 value, global half* out) {
#ifdef MORPHCL_POCL
  ushort bits[LANES];
  vstore_half16(value, 0, (private half*)bits);
  STORE_PAST_CACHE(vload16(0, bits), (global ushort16*)out);
#else
  vstore_half16(value, 0, out);
#endif
}

kernel void shade_tiles(constant const FrameConstants* restrict frame, global const DrawConstants* restrict draws,
                        global const BlockConstants* restrict blocks_of, global const uint* restrict indices,
                        global const LightConstants* restrict lights, global const int4* restrict vertices,
                        global const int4* restrict attributes, global const int4* restrict colors,
                        global const int4* restrict face_light, global const uint* restrict clip_source,
                        global const float4* restrict clip_weights, global const ChunkStatus* restrict status,
                        global const uint* restrict fragment_heads, global const uint* restrict fragment_next,
                        global const ulong* restrict fragment_keys, global const ushort* restrict fragment_places,
                        global const uint* restrict entry_heads, global const uint* restrict entry_next,
                        global const uint* restrict entry_triangles, global const LargeTriangle* restrict large,
                        global const uint* restrict overflow, global half* restrict red, global half* restrict green,
                        global half* restrict blue, global half* restrict alpha, global float* restrict distance,
                        local float* tile_depths, local uint* tile_ids) {
  if (*overflow) return;  // the bins are incomplete: the host makes room and starts again
  const uint tiles = (uint)(frame->tiles_x * frame->tiles_y), chunks = frame->chunk_count;
  const uint number = ((uint)get_global_id(0) * frame->tile_step) % tiles;
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
    for (int i = 0; i < TILE * TILE; i += LANES) {
      vstore16((float16)(frame->far_depth), 0, tile.depth + i);
      vstore16((uint16)(NO_ID), 0, tile.id + i);
    }
    for (uint chunk = 0; chunk < chunks; chunk++)
      merge_fragments(tile, fragment_keys + (size_t)chunk * frame->fragment_pages * PAGE,
                      fragment_places + (size_t)chunk * frame->fragment_pages * PAGE,
                      fragment_next + (size_t)chunk * frame->fragment_pages, fragment_heads[(size_t)chunk * tiles + number]);
    blocks.content = PER_PIXEL;
    if (any_entry) {
      float least_of[LANES], greatest_of[LANES];
      for (int block = 0; block < LANES; block++) {
        float16 low = INFINITY, high = -INFINITY;
        for (int y = 0; y < TILE_BLOCK; y++) {
          const float16 held = vload16(0, tile.depth + ((block >> 2) * TILE_BLOCK + y) * TILE + (block & 3) * TILE_BLOCK);
          low = min(low, held), high = max(high, held);
        }
        least_of[block] = least(low), greatest_of[block] = greatest(high);
      }
      blocks.least = vload16(0, least_of), blocks.greatest = vload16(0, greatest_of);
    }
  }

  // ---- 3
  if (any_entry)
    for (uint chunk = 0; chunk < chunks; chunk++) {
      global const uint* numbers = entry_triangles + (size_t)chunk * frame->entry_pages * PAGE;
      global const uint* next = entry_next + (size_t)chunk * frame->entry_pages;
      for (uint head = entry_heads[(size_t)chunk * tiles + number]; head;) {
        const uint page = (head - 1) / PAGE;
        for (uint i = page * PAGE; i < head; i++)
          merge_large_triangle(tile, &blocks, large, chunk * frame->large_capacity + numbers[i], frame->far_depth);
        head = next[page] ? (next[page] + 1) * PAGE : 0;
      }
    }

  // ---- 4
  uint content[LANES];
  vstore16(blocks.content, 0, content);
  Shader shader;
  shader.frame = frame, shader.draws = draws, shader.blocks = blocks_of, shader.indices = indices, shader.lights = lights;
  shader.vertices = vertices, shader.attributes = attributes, shader.colors = colors, shader.face_light = face_light;
  shader.clip_source = clip_source, shader.clip_weights = clip_weights;
  shader.clipped = 0;
  if (frame->clips)
    for (uint chunk = 0; chunk < chunks; chunk++) shader.clipped += status[chunk].clipped;

  const int rows = min(TILE, frame->height - tile.y);
  for (int row = 0; row < rows; row++)
    for (int column = 0; column < TILE; column += LANES) {
      const size_t at = (size_t)(tile.y + row) * frame->row_pitch + tile.x + column;
      const uint block = content[(row / TILE_BLOCK) * 4 + column / TILE_BLOCK];
      Pixels pixels;
      pixels.x = tile.x + column, pixels.y = tile.y + row;
      if (block == CLEAR) {
        pixels.same = true, pixels.first_id = NO_ID;
      } else if (block == PER_PIXEL) {
        pixels.depth = vload16(0, tile.depth + row * TILE + column);
        pixels.id = vload16(0, tile.id + row * TILE + column);
        pixels.first_id = pixels.id.s0;
        pixels.same = !any_lane(pixels.id != pixels.first_id);
      } else {
        global const LargeTriangle* t = &large[block];
        pixels.depth = fma((float16)(t->depth_dx), convert_float16(LANE + column),
                           (float16)(fma(t->depth_dy, (float)row, tile_depth(t, tile))));
        pixels.first_id = t->id;
        pixels.id = t->id, pixels.same = true;
      }
      if (pixels.same && pixels.first_id == NO_ID) {
        if (frame->writes_color) {
          store_half((float16)0.0f, red + at), store_half((float16)0.0f, green + at);
          store_half((float16)0.0f, blue + at), store_half((float16)0.0f, alpha + at);
        }
        if (frame->writes_depth) STORE_PAST_CACHE((float16)BACKGROUND_DEPTH, (global float16*)(distance + at));
        continue;
      }
      const int16 background = pixels.id == NO_ID;
      if (frame->writes_color) {
        const Irradiance color = shade(&shader, pixels);
        store_half(select(color.r, (float16)0.0f, background), red + at);
        store_half(select(color.g, (float16)0.0f, background), green + at);
        store_half(select(color.b, (float16)0.0f, background), blue + at);
        store_half(select((float16)1.0f, (float16)0.0f, background), alpha + at);
      }
      if (frame->writes_depth)
        STORE_PAST_CACHE(select(eye_distance(frame, pixels.depth), (float16)BACKGROUND_DEPTH, background),
                         (global float16*)(distance + at));
    }
}
