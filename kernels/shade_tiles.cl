#pragma OPENCL FP_CONTRACT OFF
// shade_tiles: what is visible at each pixel, its colour and its distance.
//
// In:  the chunks' bins, vertices, attributes, colours, face colours, clipped primitives, draws, lights.
// Out: the picture: rows of half R, G, B, A (premultiplied), of float Z, and of notes, row_bytes from one to the next.
//      The notes of a row of tiles stand in its first row, a uint a tile: bit b is set when block b of the tile holds
//      nothing but 0 and the background's distance, for the next frame to leave as it is.
// Steps for a tile: 1 clear; 2 merge fragments; 3 merge large triangles, 16 x 16 pixels at a time, where a triangle
//   that covers a block in front of all it holds replaces the block by a note (hierarchical depth); 4 shade each
//   visible sample once, 16 pixels of a row at a time, and store.
// A sample keeps the maximum of depth, of equal ones the lowest id, so the order of merging does not matter. Where the
// plan proved that no sample is covered twice, samples are placed without being compared.
// Where some draw is blended (-DBLENDS), layers.h finds what lies in front of the opaque surfaces before step 4.
// One work-item draws a tile. A launch draws a band of the picture, whole rows of tiles: its first work-item has the
// number of the first tile, and `picture` begins with that tile's first row.

#include "depth_format.h"
#include "layout.h"
#include "light.h"
#include "raster.h"
#include "shade.h"
#include "tables.h"
#include "tile.h"
#include "tile_ids.h"
#include "tile_pixels.h"
#include "vector.h"
#ifdef BLENDS
#include "layers.h"
#endif

#ifdef BLENDS
// One row of a block that layers may lie in front of.
ALWAYS_INLINE RowColor shade_layered_row(const Shader* s, Tile tile, int block, int row, const LayeredRow* layers,
                                         TilePixels pixels) {
  const int at = vector_in_tile(block, row - row_of(block), 0);
  const uint16 ids = tile.id[at];
  const int16 background = ids == NO_ID;
  Pixels p;
  p.x = tile.x + column_of(block);
  p.y = tile.y + row;
  p.depth = tile.depth[at];
  Rgb color;
  color.r = color.g = color.b = 0.0f;
  if (s->frame->writes_color && any_lane(~background)) color = mixed_color(s, p, ids);
  float16 alpha = select((float16)(1.0f), 1.0f - layers->transmittance[0], background);
  if (s->frame->has_background) {
    const ushort4 halves = background_rows(s->frame)[p.y];
    const float4 behind = vload_half4(0, (private const half*)&halves);
    color.r = select(color.r, (float16)(behind.x), background);
    color.g = select(color.g, (float16)(behind.y), background);
    color.b = select(color.b, (float16)(behind.z), background);
    alpha = select(alpha, (float16)(behind.w), background);
  }
  color.r = color.r * layers->transmittance[0] + layers->red[0];
  color.g = color.g * layers->transmittance[0] + layers->green[0];
  color.b = color.b * layers->transmittance[0] + layers->blue[0];
  if (s->frame->writes_depth) {
    const int16 nearer = layers->id[0] != NO_ID;
    const Depths depth = select(p.depth, layers->depth, nearer);
    const float16 distance = select(eye_distance(s->frame, decoded_depth(depth, s->frame)), (float16)(BACKGROUND_DEPTH),
                                    background & ~nearer);
    STREAM_STORE(distance,
                 (global float16*)(pixels.distance + row * pixels.row_bytes + column_of(block) * sizeof(float)));
  }
  return row_color(color, alpha);
}
#endif

// One row of a block: stores its distances and returns its colours.
ALWAYS_INLINE RowColor shade_row_of_block(const Shader* s, Column* column, Tile tile, int first, int row,
                                          TilePixels pixels) {
  Pixels p;
  p.x = tile.x + first;
  p.y = tile.y + row;
  Rgb color;
  color.r = color.g = color.b = 0.0f;
  float16 alpha = 0.0f, distance = BACKGROUND_DEPTH;
  int16 background = -1;
  if (column->content == PER_PIXEL) {
    const uint16 ids = tile.id[row * ROW_VECTORS + first / LANES];
    const uint first_id = ids.s0;
    p.depth = tile.depth[row * ROW_VECTORS + first / LANES];
    if (any_lane(ids != first_id)) {
      background = ids == NO_ID;
      if (s->frame->writes_color) color = mixed_color(s, p, ids);
      alpha = select((float16)1.0f, (float16)0.0f, background);
      distance =
          select(eye_distance(s->frame, decoded_depth(p.depth, s->frame)), (float16)BACKGROUND_DEPTH, background);
    } else if (first_id != NO_ID) {
      if (s->frame->writes_color) color = color_of_primitive(s, column, first_id, p);
      background = 0;
      alpha = 1.0f;
      distance = eye_distance(s->frame, decoded_depth(p.depth, s->frame));
    }
  } else if (column->content != CLEAR) {
    p.depth = depths_in_covered_row(column->triangle, column->origin, column->columns, row);
    if (s->frame->writes_color) color = color_of_primitive(s, column, column->triangle->id, p);
    background = 0;
    alpha = 1.0f;
    distance = eye_distance(s->frame, decoded_depth(p.depth, s->frame));
  }
  if (s->frame->writes_depth)
    STREAM_STORE(distance, (global float16*)(pixels.distance + row * pixels.row_bytes + first * sizeof(float)));
  const RowColor halves = row_color(color, alpha);
  return s->frame->has_background ? over_background(halves, s->frame, p.y, background) : halves;
}

COMPILED_ONCE void shade_tile(uint place, TileRange tiles, global const FrameConstants* restrict frame,
                              global const DrawConstants* restrict draws, global const uint* restrict indices,
                              global const int4* restrict vertices, global const int4* restrict attributes,
                              global const int4* restrict colors, global const int4* restrict face_colors,
                              global const ClippedPrimitive* restrict clipped, global Fragment* restrict fragment_keys,
                              global BinsHeader* restrict bins, global LargeTriangle* restrict large,
                              global uchar* restrict picture, TILE_MEMORY Depths* tile_depths,
                              TILE_MEMORY uint16* tile_ids
#ifdef BLENDS
                              ,
                              LayerPlanes* layer_planes, LayeredRow* layered_rows
#endif
) {
  if (bins->overflow) return;  // the bins are incomplete: the host makes room and starts again
  const uint chunks = frame->chunk_count, number = tile_at(place, tiles, frame);
  Tile tile;
  tile.depth = tile_depths;
  tile.id = tile_ids;
  tile.x = (int)(number % (uint)frame->tiles_x) * TILE;
  tile.y = (int)(number / (uint)frame->tiles_x) * TILE;

  // ---- 1, 2
  Blocks blocks;
  blocks.content = CLEAR;
  blocks.min = blocks.max = background_depth(frame);
  bool any_fragment = false, any_entry = false;
  for (uint chunk = 0; chunk < chunks; chunk++) {
    const ChunkBins own = bins_of_chunk(chunk, frame, bins, fragment_keys, large);
    any_fragment |= own.fragment_heads[number] != 0;
    any_entry |= own.entry_heads[number] != 0;
  }
  if (any_fragment) {
    for (int i = 0; i < TILE * ROW_VECTORS; i++) {
      tile.depth[i] = background_depth(frame);
      tile.id[i] = NO_ID;
    }
    for (uint chunk = 0; chunk < chunks; chunk++) {
      const ChunkBins own = bins_of_chunk(chunk, frame, bins, fragment_keys, large);
      if (frame->tests_depth)
        merge_fragments(tile, own, own.fragment_heads[number]);
      else
        place_fragments(tile, own, own.fragment_heads[number]);
    }
    survey_blocks(tile, &blocks);
  }

  // ---- 3
  if (any_entry)
    for (uint chunk = 0; chunk < chunks; chunk++) {
      const ChunkBins own = bins_of_chunk(chunk, frame, bins, fragment_keys, large);
      const uint first_large = chunk * frame->large_capacity;
      for (uint head = own.entry_heads[number]; head; head = head_before(own.entry_next, head)) {
        for (uint i = first_of_page(head); i < head; i++) PREFETCH(&own.large[own.entry_triangles[i] & ~ENTIRE_TILE]);
        for (uint i = first_of_page(head); i < head; i++) {
          const uint entry = first_large + own.entry_triangles[i];
          if (frame->tests_depth)
            merge_large_triangle(tile, &blocks, large, entry, background_depth(frame));
          else
            place_large_triangle(tile, &blocks, large, entry, background_depth(frame));
        }
      }
    }
#ifdef BLENDS
  const BlendedLists lists = {frame, bins, fragment_keys, large, number};
  Layers layers = {layer_planes, layered_rows, 0};
  find_layers(&layers, &lists, tile, &blocks, large);
#endif
  // What the next work-item begins with.
  const uint next_number = tile_at(place + 1, tiles, frame);
  for (uint chunk = 0; chunk < chunks; chunk++) {
    const ChunkBins own = bins_of_chunk(chunk, frame, bins, fragment_keys, large);
    const uint head = own.entry_heads[next_number];
    for (uint i = first_of_page(head); i < head; i += LANES) PREFETCH(&own.entry_triangles[i]);
  }

  // ---- 4
  const Lanes content = lanes_of(blocks.content);
  const uint blank = bits_of_mask(blocks.content == CLEAR);
  const size_t first_row = (number - tiles.first) / (uint)frame->tiles_x * TILE;
  const TilePixels pixels =
      pixels_of_tile(frame, picture + first_row * frame->row_bytes, number % (uint)frame->tiles_x);
  const uint left_as_it_is = mark_blank_blocks(blank, frame, pixels);
  if (frame->writes_ids) {
    store_ids(tile, blocks.content, left_as_it_is, large, ids_of_tile(number - tiles.first, bins, frame));
#ifndef BLENDS
    if (!(frame->writes_color | frame->writes_depth)) return;
#endif
  }

  const Shader shader = shader_of(frame, draws, indices, vertices, attributes, colors, face_colors, clipped, bins);
  Column columns[TILE / TILE_BLOCK];
  for (int i = 0; i < TILE / TILE_BLOCK; i++) columns[i].surface_id = NO_ID;

  RowColor left;
  left.red = left.green = left.blue = left.alpha = 0;
  const int rows = min(TILE, frame->height - tile.y);
  for (int first_row = 0; first_row < rows; first_row += TILE_BLOCK) {
    const int first_block = first_row / TILE_BLOCK * (TILE / TILE_BLOCK);
    for (int i = 0; i < TILE / TILE_BLOCK; i++)
      start_block(&columns[i], tile, i * TILE_BLOCK, content.lane[first_block + i], large);
#ifdef BLENDS
    blend_strip(&layers, &shader, &lists, tile, &blocks, first_row / TILE_BLOCK, min(TILE_BLOCK, rows - first_row));
    if (frame->writes_ids)
      store_layered_ids(&layers, tile, first_row / TILE_BLOCK, min(TILE_BLOCK, rows - first_row),
                        ids_of_tile(number - tiles.first, bins, frame));
    if (!(frame->writes_color | frame->writes_depth)) continue;
#endif
    if (strip_is_left(left_as_it_is, first_block)) continue;
    for (int row = first_row; row < min(first_row + TILE_BLOCK, rows); row++)
      for (int i = 0; i < TILE / TILE_BLOCK; i++) {
        if (left_as_it_is >> (first_block + (i & ~1)) & 1u) continue;
#ifdef BLENDS
        const RowColor color = layers.blocks >> (first_block + i) & 1u
                                   ? shade_layered_row(&shader, tile, first_block + i, row,
                                                       &layers.rows[i * TILE_BLOCK + (row - first_row)], pixels)
                                   : shade_row_of_block(&shader, &columns[i], tile, i * TILE_BLOCK, row, pixels);
#else
        const RowColor color = shade_row_of_block(&shader, &columns[i], tile, i * TILE_BLOCK, row, pixels);
#endif
        if (i & 1 && frame->writes_color) store_colors(left, color, pixels, (i - 1) * TILE_BLOCK, row);
        left = color;
      }
  }
}

kernel void shade_tiles(global const FrameConstants* frame, global const DrawConstants* draws,
                        global const uint* indices, global const int4* vertices, global const int4* attributes,
                        global const int4* colors, global const int4* face_colors,
                        global const ClippedPrimitive* clipped, global ulong* fragment_keys, global BinsHeader* bins,
                        global LargeTriangle* large, global uchar* picture) {
  TILE_MEMORY Depths tile_depths[TILE_VECTORS];
  TILE_MEMORY uint16 tile_ids[TILE_VECTORS];
  const TileRange tiles = {(uint)get_global_offset(0), (uint)get_global_size(0)};
#ifdef BLENDS
  LayerPlanes layer_planes;
  LayeredRow layered_rows[STRIP_ROWS];
#endif
  shade_tile((uint)get_global_id(0) - tiles.first, tiles, frame, draws, indices, vertices, attributes, colors,
             face_colors, clipped, fragment_keys, bins, large, picture, tile_depths, tile_ids
#ifdef BLENDS
             ,
             &layer_planes, layered_rows
#endif
  );
}
