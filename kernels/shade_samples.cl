#pragma OPENCL FP_CONTRACT OFF
// shade_samples: what is visible at each sample of each pixel, and the pixels' colours and alphas: shade_tiles for
// several samples a pixel (-DSAMPLES=N). Distances are those of the pixels' centres, which shade_tiles finds in a pass
// of its own.
//
// In:  as shade_tiles, with fragments that have a bit a sample.
// Out: the picture's rows of half R, G, B, A (premultiplied), and its notes.
// Steps for a tile: 1 merge fragments; 2 merge large triangles, by blocks of 16 x 16 pixels, of which one that a
// triangle
//   covers in front of all it holds is no more than a note; 3 of the other blocks list the parts: a pixel, a primitive
//   that some of its samples show, how many, and their centroid; 4 shade the parts, 16 at a time, and add them up;
//   5 shade what shows one primitive in whole rows, as shade_tiles does, and store.
// A pixel is the sum of the background and of its parts in the order of their first samples, colour times number of
// samples, over the number of all. A part is shaded at the pixel's centre where that is in its triangle, else at the
// centroid: so a pixel that shows one primitive has the colour that a single sample has.
// Where some draw is blended (-DBLENDS), layers.h finds what lies in front of the opaque surfaces before step 3.
// One work-item draws a tile, and a launch a band of the picture, as of shade_tiles.

#ifndef SAMPLES
#define SAMPLES 4  // for who reads this file alone
#endif

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

#define SHARE_OF_SAMPLE (1.0f / SAMPLES)

// ---- parts of pixels ------------------------------------------------------------------------------------------------

// Parts that wait to be shaded: less than a vector, what a row of a block adds, and room behind them.
#define MAX_PARTS (LANES + LANES * SAMPLES + LANES)
typedef struct {
  uint count;
  uint id[MAX_PARTS];
  uint place[MAX_PARTS];     // row << 4 | column in the block, number of samples above
  uint centroid[MAX_PARTS];  // from the centre, sub-pixels: x in the lower half, y in the upper one
} Parts;
#define PLACE_BITS 8
#define MANY_PARTS 10  // of a row: they are shaded before they are collected

// The sums of a row of blocks: R, G, B, A of each pixel.
#define BLOCK_PIXELS (TILE_BLOCK * TILE_BLOCK)
typedef struct {
  float4 pixel[BLOCK_PIXELS];
  uint mixed_rows;  // a bit a row: those that are not of one primitive, whose pixels stand here
} Sums;

// Sixteen pixels of four channels each, from vectors of a channel and back.
ALWAYS_INLINE void store_pixels(float16 r, float16 g, float16 b, float16 a, float4* out) {
  const int16 f0 = as_int16(r), f1 = as_int16(g), f2 = as_int16(b), f3 = as_int16(a);
  vstore16(INTERLEAVE_4(f0, f1, f2, f3, 0, 1, 2, 3), 0, (private int*)out);
  vstore16(INTERLEAVE_4(f0, f1, f2, f3, 4, 5, 6, 7), 1, (private int*)out);
  vstore16(INTERLEAVE_4(f0, f1, f2, f3, 8, 9, a, b), 2, (private int*)out);
  vstore16(INTERLEAVE_4(f0, f1, f2, f3, c, d, e, f), 3, (private int*)out);
}
ALWAYS_INLINE void load_pixels(const float4* in, float16* r, float16* g, float16* b, float16* a) {
  const float16 p0 = vload16(0, (private const float*)in), p1 = vload16(1, (private const float*)in),
                p2 = vload16(2, (private const float*)in), p3 = vload16(3, (private const float*)in);
  *r = (float16)(p0.s048c, p1.s048c, p2.s048c, p3.s048c);
  *g = (float16)(p0.s159d, p1.s159d, p2.s159d, p3.s159d);
  *b = (float16)(p0.s26ae, p1.s26ae, p2.s26ae, p3.s26ae);
  *a = (float16)(p0.s37bf, p1.s37bf, p2.s37bf, p3.s37bf);
}

ALWAYS_INLINE void add_parts(Parts* parts, int16 lanes, uint16 id, uint16 place, uint16 centroid) {
  const Lanes ids = lanes_of(id), places = lanes_of(place), centroids = lanes_of(centroid);
  uint count = parts->count;
  FOR_EACH_LANE(lane, lanes) {
    parts->id[count] = ids.lane[lane];
    parts->place[count] = places.lane[lane];
    parts->centroid[count] = centroids.lane[lane];
    count++;
  }
  parts->count = count;
}

// The colours of parts; `waiting` are those that there are.
COMPILED_ONCE Rgb colors_of_parts(const Shader* s, const Pixels* places, uint16 ids, int16 waiting) {
  const Lanes of_lanes = lanes_of(ids);
  const uint first_id = of_lanes.lane[first_lane(waiting)];
  const uint16 all = select((uint16)(first_id), ids, as_uint16(waiting));
  if (any_lane(all != first_id)) return mixed_color(s, *places, all);
  Surface surface;
  gather_surface(s, draw_of(s, first_id), lanes_of(first_id), true, &surface);
  return surface_color(s, &surface, *places);
}

ALWAYS_INLINE void add_color(Rgb color, int16 lanes, float16 samples, Rgb* sum) {
  sum->r = select(sum->r, fma(color.r, samples, sum->r), lanes);
  sum->g = select(sum->g, fma(color.g, samples, sum->g), lanes);
  sum->b = select(sum->b, fma(color.b, samples, sum->b), lanes);
}

// Sums up 16 pixels of a row, whose first is (x, y) of the picture, or lists parts of them. Parts that are many in a
// row, and the first of their pixels, are shaded at once.
ALWAYS_INLINE void sum_up_row(const Shader* s, uint16* ids, int x, int y, int row_in_block, Parts* parts, Sums* sums) {
  split_samples(ids);
  Rgb sum;
  sum.r = sum.g = sum.b = 0.0f;
  float16 empty = 0.0f;
  _Pragma("unroll") for (int i = 0; i < SAMPLES; i++) empty -= convert_float16(ids[i] == NO_ID);
  float16 alpha = (float)SAMPLES - empty;
  if (s->frame->has_background) {
    const ushort4 halves = background_rows(s->frame)[y];
    const float4 behind = vload_half4(0, (private const half*)&halves);
    sum.r = fma((float16)(behind.x), empty, sum.r);
    sum.g = fma((float16)(behind.y), empty, sum.g);
    sum.b = fma((float16)(behind.z), empty, sum.b);
    alpha = fma((float16)(behind.w), empty, alpha);
  }
  const uint listed_before = parts->count;
  _Pragma("unroll") for (int i = 0; i < SAMPLES; i++) {
    int16 first = ids[i] != NO_ID;
    _Pragma("unroll") for (int before = 0; before < i; before++) first &= ids[before] != ids[i];
    if (!any_lane(first)) continue;
    int16 count = 0;
    _Pragma("unroll") for (int other = i; other < SAMPLES; other++) count -= ids[other] == ids[i];
    const float16 samples = convert_float16(count);
    if (s->frame->only_faces) {
      add_color(colors_of_faces(s, ids[i], first), first, samples, &sum);
      continue;
    }
    int16 sum_x = 0, sum_y = 0;
    _Pragma("unroll") for (int other = i; other < SAMPLES; other++) {
      const int16 same = ids[other] == ids[i];
      sum_x += same & sample_x[other];
      sum_y += same & sample_y[other];
    }
    const int16 centroid_x = mean_offset(sum_x, samples), centroid_y = mean_offset(sum_y, samples);
    if (parts->count == listed_before && popcount(bits_of_mask(first)) >= MANY_PARTS) {
      Pixels p;
      p.x = (x + LANE) * SUBPIXELS + HALF_PIXEL;
      p.y = y * SUBPIXELS + HALF_PIXEL;
      p.centroid_x = centroid_x;
      p.centroid_y = centroid_y;
      p.centres_are_inside = false;
      add_color(colors_of_parts(s, &p, ids[i], first), first, samples, &sum);
    } else {
      add_parts(parts, first, ids[i], as_uint16(LANE + row_in_block * TILE_BLOCK) | as_uint16(count) << PLACE_BITS,
                (as_uint16(centroid_x) & 0xffffu) | as_uint16(centroid_y) << 16);
    }
  }
  store_pixels(sum.r, sum.g, sum.b, alpha, &sums->pixel[row_in_block * TILE_BLOCK]);
}

// Shades the parts from `first` on, 16 at most, of a block whose first pixel is (x, y), and adds them to the sums.
ALWAYS_INLINE void shade_parts(const Shader* s, const Parts* parts, uint first, int x, int y, Sums* sums) {
  const uint count = min(parts->count - first, (uint)LANES);
  const uint16 ids = vload16(0, &parts->id[first]), places = vload16(0, &parts->place[first]);
  const int16 centroids = as_int16(vload16(0, &parts->centroid[first]));
  const int16 in_block = as_int16(places & (BLOCK_PIXELS - 1u));
  Pixels p;
  p.x = (x + (in_block & (TILE_BLOCK - 1))) * SUBPIXELS + HALF_PIXEL;
  p.y = (y + in_block / TILE_BLOCK) * SUBPIXELS + HALF_PIXEL;
  p.centroid_x = centroids << 16 >> 16;
  p.centroid_y = centroids >> 16;
  p.centres_are_inside = false;
  const Rgb color = colors_of_parts(s, &p, ids, LANE < (int)count);
  float4 color_of[LANES];
  store_pixels(color.r, color.g, color.b, 0.0f, color_of);
  for (uint i = 0; i < count; i++) {
    const uint place = parts->place[first + i];
    float4* sum = &sums->pixel[place & (BLOCK_PIXELS - 1u)];
    *sum = fma(color_of[i], (float4)((float)(place >> PLACE_BITS)), *sum);
  }
}

// All whole vectors of parts; or all there are.
ALWAYS_INLINE void shade_waiting_parts(const Shader* s, Parts* parts, bool all, int x, int y, Sums* sums) {
  uint first = 0;
  for (; first + (all ? 1 : LANES) <= parts->count; first += LANES) shade_parts(s, parts, first, x, y, sums);
  const uint left = first < parts->count ? parts->count - first : 0;
  if (left && first) {
    vstore16(vload16(0, &parts->id[first]), 0, parts->id);
    vstore16(vload16(0, &parts->place[first]), 0, parts->place);
    vstore16(vload16(0, &parts->centroid[first]), 0, parts->centroid);
  }
  parts->count = left;
}

// The sums of the rows of a block, `rows` of them, that show more than one primitive.
static inline void add_up_block(const Shader* s, Tile tile, int block, int rows, Parts* parts, Sums* sums) {
  const int x = tile.x + column_of(block), y = tile.y + row_of(block);
  parts->count = 0;
  sums->mixed_rows = 0;
  for (int row = 0; row < rows; row++) {
    uint16 ids[SAMPLES];
    _Pragma("unroll") for (int k = 0; k < SAMPLES; k++) ids[k] = tile.id[block * BLOCK_VECTORS + row * SAMPLES + k];
    const uint first_id = ids[0].s0;
    int16 others = 0;
    _Pragma("unroll") for (int k = 0; k < SAMPLES; k++) others |= ids[k] != first_id;
    if (!any_lane(others)) continue;
    sums->mixed_rows |= 1u << row;
    sum_up_row(s, ids, x, y + row, row, parts, sums);
    if (parts->count >= LANES) shade_waiting_parts(s, parts, false, x, y, sums);
  }
  if (parts->count) shade_waiting_parts(s, parts, true, x, y, sums);
}

#ifdef BLENDS
// Sums up 16 pixels of a row that layers may lie in front of.
static inline void sum_up_layered_row(const Shader* s, uint16* ids, int x, int y, int row_in_block,
                                      const LayeredRow* layers, Sums* sums) {
  split_samples(ids);
  Rgb sum;
  sum.r = sum.g = sum.b = 0.0f;
  float16 empty = 0.0f, through_empty = 0.0f, alpha_of_empty = 0.0f;
  for (int i = 0; i < SAMPLES; i++) {
    const int16 here = ids[i] == NO_ID;
    empty -= convert_float16(here);
    through_empty = select(through_empty, through_empty + layers->transmittance[i], here);
    alpha_of_empty = select(alpha_of_empty, alpha_of_empty + (1.0f - layers->transmittance[i]), here);
  }
  float16 alpha = (float)SAMPLES - empty;
  if (s->frame->has_background) {
    const ushort4 halves = background_rows(s->frame)[y];
    const float4 behind = vload_half4(0, (private const half*)&halves);
    sum.r = through_empty * behind.x;
    sum.g = through_empty * behind.y;
    sum.b = through_empty * behind.z;
    alpha = fma((float16)(behind.w), empty, alpha);
  } else {
    alpha += alpha_of_empty;
  }
  for (int i = 0; i < SAMPLES; i++) {
    int16 first = ids[i] != NO_ID;
    for (int before = 0; before < i; before++) first &= ids[before] != ids[i];
    if (!any_lane(first)) continue;
    int16 count = 0, sum_x = 0, sum_y = 0;
    float16 through = 0.0f;
    for (int other = i; other < SAMPLES; other++) {
      const int16 same = ids[other] == ids[i];
      count -= same;
      sum_x += same & sample_x[other];
      sum_y += same & sample_y[other];
      through = select(through, through + layers->transmittance[other], same);
    }
    Pixels p;
    p.x = (x + LANE) * SUBPIXELS + HALF_PIXEL;
    p.y = y * SUBPIXELS + HALF_PIXEL;
    p.centroid_x = mean_offset(sum_x, convert_float16(count));
    p.centroid_y = mean_offset(sum_y, convert_float16(count));
    p.centres_are_inside = false;
    add_color(colors_of_parts(s, &p, ids[i], first), first, through, &sum);
  }
  for (int i = 0; i < SAMPLES; i++) {
    sum.r += layers->red[i];
    sum.g += layers->green[i];
    sum.b += layers->blue[i];
  }
  store_pixels(sum.r, sum.g, sum.b, alpha, &sums->pixel[row_in_block * TILE_BLOCK]);
}

static inline void add_up_layered_block(const Shader* s, Tile tile, int block, int rows, const LayeredRow* layers,
                                        Sums* sums) {
  sums->mixed_rows = (1u << TILE_BLOCK) - 1;
  for (int row = 0; row < rows; row++) {
    uint16 ids[SAMPLES];
    for (int k = 0; k < SAMPLES; k++) ids[k] = tile.id[vector_in_tile(block, row, k)];
    sum_up_layered_row(s, ids, tile.x + column_of(block), tile.y + row_of(block) + row, row, &layers[row], sums);
  }
}
#endif

// ---- tiles ----------------------------------------------------------------------------------------------------------

// The colours of one row of a block.
ALWAYS_INLINE RowColor shade_row_of_block(const Shader* s, Column* column, Tile tile, int block, int row,
                                          const Sums* sums) {
  const int row_in_block = row - row_of(block);
  if (column->content == PER_PIXEL && sums->mixed_rows >> row_in_block & 1u) {
    Rgb sum;
    float16 alpha;
    load_pixels(&sums->pixel[row_in_block * TILE_BLOCK], &sum.r, &sum.g, &sum.b, &alpha);
    sum.r *= SHARE_OF_SAMPLE;
    sum.g *= SHARE_OF_SAMPLE;
    sum.b *= SHARE_OF_SAMPLE;
    return row_color(sum, alpha * SHARE_OF_SAMPLE);
  }
  uint id = NO_ID;
  if (column->content == PER_PIXEL)
    id = tile.id[block * BLOCK_VECTORS + row_in_block * SAMPLES].s0;
  else if (column->content != CLEAR)
    id = column->triangle->id;
  if (id == NO_ID) {
    Rgb nothing;
    nothing.r = nothing.g = nothing.b = 0.0f;
    const RowColor halves = row_color(nothing, 0.0f);
    return s->frame->has_background ? over_background(halves, s->frame, tile.y + row, (int16)(-1)) : halves;
  }
  Pixels p;
  p.x = (tile.x + column_of(block) + LANE) * SUBPIXELS + HALF_PIXEL;
  p.y = (tile.y + row) * SUBPIXELS + HALF_PIXEL;
  p.centroid_x = p.centroid_y = 0;
  p.centres_are_inside = true;
  return row_color(color_of_primitive(s, column, id, p), 1.0f);
}

COMPILED_ONCE void shade_tile(uint place, TileRange tiles, global const FrameConstants* restrict frame,
                              global const DrawConstants* restrict draws, global const uint* restrict indices,
                              global const int4* restrict vertices, global const int4* restrict attributes,
                              global const int4* restrict colors, global const int4* restrict face_colors,
                              global const ClippedPrimitive* restrict clipped,
                              global SampleFragment* restrict sample_fragments, global BinsHeader* restrict bins,
                              global LargeTriangle* restrict large, global uchar* restrict picture,
                              TILE_MEMORY Depths* tile_depths, TILE_MEMORY uint16* tile_ids
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

  // ---- 1
  Blocks blocks;
  blocks.content = CLEAR;
  blocks.min = blocks.max = background_depth(frame);
  uint touched = 0;
  for (uint chunk = 0; chunk < chunks; chunk++) {
    const ChunkBins own = bins_of_chunk(chunk, frame, bins, (global Fragment*)sample_fragments, large);
    if (chunk + 1 < chunks) {
      const ChunkBins next = bins_of_chunk(chunk + 1, frame, bins, (global Fragment*)sample_fragments, large);
      prefetch_fragments(next, next.fragment_heads[number]);
    }
    merge_fragments(tile, own, own.fragment_heads[number], background_depth(frame), &touched);
  }
  if (touched) survey_blocks(tile, touched, &blocks);

  // ---- 2
  for (uint chunk = 0; chunk < chunks; chunk++) {
    const ChunkBins own = bins_of_chunk(chunk, frame, bins, (global Fragment*)sample_fragments, large);
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
  const BlendedLists lists = {frame, bins, (global Fragment*)sample_fragments, large, number};
  Layers layers = {layer_planes, layered_rows, 0};
  find_layers(&layers, &lists, tile, &blocks, large);
#endif

  // ---- 3, 4, 5
  const Lanes content = lanes_of(blocks.content);
  const uint blank = bits_of_mask(blocks.content == CLEAR);
  const size_t first_row = (number - tiles.first) / (uint)frame->tiles_x * TILE;
  const TilePixels pixels =
      pixels_of_tile(frame, picture + first_row * frame->row_bytes, number % (uint)frame->tiles_x);
  const uint left_as_it_is = mark_blank_blocks(blank, frame, pixels);
  if (frame->writes_ids) {
    store_ids(tile, blocks.content, left_as_it_is, large, ids_of_tile(number - tiles.first, bins, frame));
#ifndef BLENDS
    if (!(frame->writes_color)) return;
#endif
  }

  const Shader shader = shader_of(frame, draws, indices, vertices, attributes, colors, face_colors, clipped, bins);
  Column columns[TILE_BLOCKS];
  for (int i = 0; i < TILE_BLOCKS; i++) columns[i].surface_id = NO_ID;
  Parts parts;
  Sums sums[TILE_BLOCKS];

  RowColor left;
  left.red = left.green = left.blue = left.alpha = 0;
  const int rows = min(TILE, frame->height - tile.y);
  for (int first = 0; first < rows; first += TILE_BLOCK) {
    const int first_block = first / TILE_BLOCK * TILE_BLOCKS, end = min(first + TILE_BLOCK, rows);
#ifdef BLENDS
    blend_strip(&layers, &shader, &lists, tile, &blocks, first / TILE_BLOCK, end - first);
    if (frame->writes_ids)
      store_layered_ids(&layers, tile, first / TILE_BLOCK, end - first, ids_of_tile(number - tiles.first, bins, frame));
    if (!frame->writes_color) continue;
#endif
    if (strip_is_left(left_as_it_is, first_block)) continue;
    for (int i = 0; i < TILE_BLOCKS; i++) {
      start_block(&columns[i], tile, i * TILE_BLOCK, content.lane[first_block + i], large);
#ifdef BLENDS
      if (layers.blocks >> (first_block + i) & 1u) {
        add_up_layered_block(&shader, tile, first_block + i, end - first, &layers.rows[i * TILE_BLOCK], &sums[i]);
        continue;
      }
#endif
      if (columns[i].content == PER_PIXEL) add_up_block(&shader, tile, first_block + i, end - first, &parts, &sums[i]);
    }
    for (int row = first; row < end; row++)
      for (int i = 0; i < TILE_BLOCKS; i++) {
        if (left_as_it_is >> (first_block + (i & ~1)) & 1u) continue;
        const RowColor color = shade_row_of_block(&shader, &columns[i], tile, first_block + i, row, &sums[i]);
        if (i & 1) store_colors(left, color, pixels, (i - 1) * TILE_BLOCK, row);
        left = color;
      }
  }
}

kernel void shade_samples(global const FrameConstants* frame, global const DrawConstants* draws,
                          global const uint* indices, global const int4* vertices, global const int4* attributes,
                          global const int4* colors, global const int4* face_colors,
                          global const ClippedPrimitive* clipped, global SampleFragment* sample_fragments,
                          global BinsHeader* bins, global LargeTriangle* large, global uchar* picture) {
  TILE_MEMORY Depths tile_depths[TILE_VECTORS];
  TILE_MEMORY uint16 tile_ids[TILE_VECTORS];
  const TileRange tiles = {(uint)get_global_offset(0), (uint)get_global_size(0)};
#ifdef BLENDS
  LayerPlanes layer_planes;
  LayeredRow layered_rows[STRIP_ROWS];
#endif
  shade_tile((uint)get_global_id(0) - tiles.first, tiles, frame, draws, indices, vertices, attributes, colors,
             face_colors, clipped, sample_fragments, bins, large, picture, tile_depths, tile_ids
#ifdef BLENDS
             ,
             &layer_planes, layered_rows
#endif
  );
}
