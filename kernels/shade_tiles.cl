#pragma OPENCL FP_CONTRACT OFF
// shade_tiles: what is visible at each pixel, its colour and its distance.
//
// In:  the chunks' bins, vertices, attributes, colours, face colours, clipped corners, draws, lights.
// Out: rows of half R, G, B, A (premultiplied) and float Z, row_bytes from one to the next, the first of tile first_tile;
//      blank_blocks[tile]: bit b set when block b of the tile holds the background, for the next frame to leave as it is.
// Steps for a tile: 1 clear; 2 merge fragments; 3 merge large triangles, 16 x 16 pixels at a time, where a triangle that
//   covers a block in front of all it holds replaces the block by a note (hierarchical depth); 4 shade each visible
//   sample once, 16 pixels of a row at a time, and store.
// A sample keeps the greatest depth, of equal ones the lowest id, so the order of merging does not matter. Where the plan
// proved that no sample is covered twice, samples are placed without being compared.
// One work-item draws a tile. A launch draws a band of the picture: whole rows of tiles from first_tile on.

#include "layout.h"
#include "vector.h"
#include "raster.h"
#include "depth_format.h"
#include "tile.h"
#include "light.h"
#include "shade.h"

// ---- pixels ---------------------------------------------------------------------------------------------------------

// The tile's pixels.
typedef struct {
  global uchar *red, *green, *blue, *alpha, *distance;  // of the first pixel
  size_t row_bytes;
} Picture;

ALWAYS_INLINE Picture picture_of_tile(constant const FrameConstants* frame, global uchar* band, int x,
                                      int row_of_band) {
  global uchar* row = band + (size_t)row_of_band * frame->row_bytes;
  Picture picture;
  picture.red = row + frame->color_offset[0] + x * sizeof(half);
  picture.green = row + frame->color_offset[1] + x * sizeof(half);
  picture.blue = row + frame->color_offset[2] + x * sizeof(half);
  picture.alpha = row + frame->color_offset[3] + x * sizeof(half);
  picture.distance = row + frame->depth_offset + x * sizeof(float);
  picture.row_bytes = frame->row_bytes;
  return picture;
}

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
  halves.red = to_halves(color.r);
  halves.green = to_halves(color.g);
  halves.blue = to_halves(color.b);
  halves.alpha = to_halves(alpha);
  return halves;
}

// Two neighbours at a time: what goes past the cache should fill its lines, of 64 bytes on most processors.
ALWAYS_INLINE void store_line(ushort16 left, ushort16 right, global uchar* out) {
  STORE_PAST_CACHE((ulong8)(as_ulong4(left), as_ulong4(right)), (global ulong8*)out);
}

ALWAYS_INLINE void store_colors(RowColor left, RowColor right, Picture picture, int first, int row) {
  const size_t at = row * picture.row_bytes + first * sizeof(half);
  store_line(left.red, right.red, picture.red + at);
  store_line(left.green, right.green, picture.green + at);
  store_line(left.blue, right.blue, picture.blue + at);
  store_line(left.alpha, right.alpha, picture.alpha + at);
}

// Sixteen columns of the rows of blocks that are shaded together. The surface is kept while its id stays.
typedef struct {
  uint content;
  global const LargeTriangle* triangle;  // a block of one triangle
  TileDepth corner;                      // its depth at the tile's first pixel
  uint surface_id;                       // NO_ID: the surface is still to be gathered
  Surface surface;
} Column;

ALWAYS_INLINE void start_block(Column* column, Tile tile, uint content, global const LargeTriangle* large) {
  column->content = content;
  if (content == CLEAR || content == PER_PIXEL) return;
  column->triangle = &large[content];
  column->corner = depth_of_tile(column->triangle, tile.x, tile.y);
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
  p.x = tile.x + first;
  p.y = tile.y + row;
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
      distance = select(eye_distance(s->frame, decoded_depth(p.depth, s->frame)), (float16)BACKGROUND_DEPTH, background);
    } else if (first_id != NO_ID) {
      if (s->frame->writes_color) color = color_of_primitive(s, column, first_id, p);
      alpha = 1.0f;
      distance = eye_distance(s->frame, decoded_depth(p.depth, s->frame));
    }
  } else if (column->content != CLEAR) {
    p.depth = depths_in_row(column->triangle, column->corner, first, row);
    if (s->frame->writes_color) color = color_of_primitive(s, column, column->triangle->id, p);
    alpha = 1.0f;
    distance = eye_distance(s->frame, decoded_depth(p.depth, s->frame));
  }
  if (s->frame->writes_depth)
    STORE_PAST_CACHE(distance, (global float16*)(picture.distance + row * picture.row_bytes + first * sizeof(float)));
  return row_color(color, alpha);
}

COMPILED_ONCE void shade_tile(uint place, uint first_tile, uint band_tiles,
                              constant const FrameConstants* restrict frame,
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
                              global uchar* restrict band, global uint* restrict blank_blocks,
                              local Depths* tile_depths, local uint16* tile_ids) {
  if (*overflow) return;  // the bins are incomplete: the host makes room and starts again
  const uint tiles = (uint)(frame->tiles_x * frame->tiles_y), chunks = frame->chunk_count;
  const uint number = first_tile + place * frame->tile_step % band_tiles;
  Tile tile;
  tile.depth = tile_depths;
  tile.id = tile_ids;
  tile.x = (int)(number % (uint)frame->tiles_x) * TILE;
  tile.y = (int)(number / (uint)frame->tiles_x) * TILE;

  // ---- 1, 2
  Blocks blocks;
  blocks.content = CLEAR;
  blocks.least = blocks.greatest = background_depth(frame);
  bool any_fragment = false, any_entry = false;
  for (uint chunk = 0; chunk < chunks; chunk++) {
    any_fragment |= fragment_heads[(size_t)chunk * tiles + number] != 0;
    any_entry |= entry_heads[(size_t)chunk * tiles + number] != 0;
  }
  if (any_fragment) {
    for (int i = 0; i < TILE * ROW_VECTORS; i++) {
      tile.depth[i] = background_depth(frame);
      tile.id[i] = NO_ID;
    }
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
      for (uint head = entry_heads[(size_t)chunk * tiles + number]; head; head = head_before(next, head)) {
        for (uint i = first_of_page(head); i < head; i++)
          FETCH_AHEAD(&large[chunk * frame->large_capacity + (entries[i] & ~ENTIRE_TILE)]);
        for (uint i = first_of_page(head); i < head; i++)
          if (frame->tests_depth)
            merge_large_triangle(tile, &blocks, large, chunk * frame->large_capacity + entries[i], background_depth(frame));
          else
            place_large_triangle(tile, &blocks, large, chunk * frame->large_capacity + entries[i], background_depth(frame));
      }
    }
  // What the next work-item begins with.
  const uint next_number = first_tile + (place + 1) * frame->tile_step % band_tiles;
  for (uint chunk = 0; chunk < chunks; chunk++) {
    const uint head = entry_heads[(size_t)chunk * tiles + next_number];
    global const uint* entries = entry_triangles + (size_t)chunk * frame->entry_pages * PAGE;
    for (uint i = first_of_page(head); i < head; i += LANES) FETCH_AHEAD(&entries[i]);
  }

  // ---- 4
  const Lanes content = lanes_of(blocks.content);
  uint blank = 0;
  for (int block = 0; block < LANES; block++) blank |= content.lane[block] == CLEAR ? 1u << block : 0u;
  uint left_as_it_is = frame->keeps_blank_tiles ? blank & blank_blocks[number] : 0u;
  left_as_it_is &= left_as_it_is >> 1;  // bits of even blocks: both of the pair
  blank_blocks[number] = blank;

  Shader shader;
  shader.frame = frame;
  shader.draws = draws;
  shader.block_draw = block_draw;
  shader.indices = indices;
  shader.lights = lights;
  shader.vertices = vertices;
  shader.attributes = attributes;
  shader.colors = colors;
  shader.face_color = face_color;
  shader.clip_source = clip_source;
  shader.clip_weights = clip_weights;
  shader.clipped = 0;
  if (frame->clips)
    for (uint chunk = 0; chunk < chunks; chunk++) shader.clipped += status[chunk].clipped;
  const int first_row_of_band = (int)(first_tile / (uint)frame->tiles_x) * TILE;
  const Picture picture = picture_of_tile(frame, band, tile.x, tile.y - first_row_of_band);
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
          store_colors(left, color, picture, (i - 1) * TILE_BLOCK, row);
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
                        global const uint* overflow, uint first_tile, global uchar* band, global uint* blank_blocks,
                        local Depths* tile_depths, local uint16* tile_ids) {
  shade_tile((uint)get_global_id(0), first_tile, (uint)get_global_size(0), frame, draws, block_draw, indices, lights,
             vertices, attributes, colors, face_color, clip_source, clip_weights, status, fragment_heads,
             fragment_next, fragment_keys, fragment_places, entry_heads, entry_next, entry_triangles, large, overflow,
             band, blank_blocks, tile_depths, tile_ids);
}
