// The samples of a tile where a pixel has several: block by block, in a block row by row, in a row pixel by pixel, and
// those of a pixel side by side. A part of tile.h.
//
//     block of 16 x 16 pixels: BLOCK_VECTORS vectors, SAMPLES a row; of four samples a pixel:
//
//     vector 0           1           2           3         of row 0, then those of row 1
//     |0123 0123 0123 0123|0123 ...   a lane a sample: all of a pixel, then all of the next
//
// So a large triangle is drawn 16 samples at a time, and a fragment, which has a bit a sample, with one short vector.

#ifndef MORPHCL_SAMPLE_PLANES_H
#define MORPHCL_SAMPLE_PLANES_H

#define BLOCK_VECTORS (TILE_BLOCK * SAMPLES)
#define TILE_VECTORS (TILE_BLOCKS * TILE_BLOCKS * BLOCK_VECTORS)

// All samples of a pixel.
#define OF_SAMPLES_JOINED(type, count) type##count
#define OF_SAMPLES_OF(type, count) OF_SAMPLES_JOINED(type, count)
typedef OF_SAMPLES_OF(float, SAMPLES) SampleFloats;
typedef OF_SAMPLES_OF(int, SAMPLES) SampleInts;
typedef OF_SAMPLES_OF(uint, SAMPLES) SampleUints;
#ifdef FORWARD_DEPTH
typedef SampleUints SampleDepths;
#else
typedef SampleFloats SampleDepths;
#endif
#if SAMPLES == 2
#define SAMPLE_BITS ((SampleUints)(1, 2))
#elif SAMPLES == 4
#define SAMPLE_BITS ((SampleUints)(1, 2, 4, 8))
#elif SAMPLES == 8
#define SAMPLE_BITS ((SampleUints)(1, 2, 4, 8, 16, 32, 64, 128))
#else
#define SAMPLE_BITS ((SampleUints)(1, 2, 4, 8, 16, 32, 64, 128, 256, 512, 1024, 2048, 4096, 8192, 16384, 32768))
#endif
#define PIXELS_OF_SAMPLE_UNIT 0x1p-4f

// ---- samples of 16 pixels -------------------------------------------------------------------------------------------

// Of the vectors of 16 pixels of a row, the vectors of each sample: in rounds that move the lowest bit of an
// element's place to the top.
ALWAYS_INLINE void split_samples(uint16* ids) {
  uint16 moved[SAMPLES];
  _Pragma("unroll") for (int round = 1; round < SAMPLES; round *= 2) {
    _Pragma("unroll") for (int i = 0; i < SAMPLES / 2; i++) {
      moved[i] = (uint16)(ids[2 * i].even, ids[2 * i + 1].even);
      moved[i + SAMPLES / 2] = (uint16)(ids[2 * i].odd, ids[2 * i + 1].odd);
    }
    _Pragma("unroll") for (int i = 0; i < SAMPLES; i++) ids[i] = moved[i];
  }
}

// The mean of the offsets of `count` samples, in sub-pixels, rounded to nearest even; of all samples the centre.
ALWAYS_INLINE int16 mean_offset(int16 sum, float16 count) {
  const int16 mean = convert_int16_rte(convert_float16(sum * SAMPLE_UNIT) / count);
  return select(mean, (int16)(0), count == (float)SAMPLES);
}

// ---- fragments ------------------------------------------------------------------------------------------------------

ALWAYS_INLINE SampleDepths depths_of_fragment(SampleFragment f) {
#ifdef FORWARD_DEPTH
  return f.depth;
#else
  const SampleFloats x = (SampleFloats)(SAMPLES_X)*PIXELS_OF_SAMPLE_UNIT,
                     y = (SampleFloats)(SAMPLES_Y)*PIXELS_OF_SAMPLE_UNIT;
  return fma((SampleFloats)(f.depth_dx), x, fma((SampleFloats)(f.depth_dy), y, (SampleFloats)(as_float(f.depth))));
#endif
}

static inline void clear_block(Tile tile, uint block, Depth background) {
  for (int i = 0; i < BLOCK_VECTORS; i++) {
    tile.depth[block * BLOCK_VECTORS + i] = background;
    tile.id[block * BLOCK_VECTORS + i] = NO_ID;
  }
}

// Asks for the fragments of the page that ends at `head`.
static inline void prefetch_fragments(ChunkBins bins, uint head) {
  for (uint i = first_of_page(head); i < head; i += 3) PREFETCH(&bins.fragments[i]);
}

// Clears a block when the first fragment comes, which `touched` notes, a bit a block. While a page is merged the next
// one is asked for.
static inline void merge_fragments(Tile tile, ChunkBins bins, uint head, Depth background, uint* touched) {
  TILE_MEMORY SampleDepths* depths = (TILE_MEMORY SampleDepths*)tile.depth;
  TILE_MEMORY SampleUints* ids = (TILE_MEMORY SampleUints*)tile.id;
  while (head) {
    const uint next = head_before(bins.fragment_next, head), to_next = first_of_page(next) - first_of_page(head);
    for (uint i = first_of_page(head); i < head; i++) {
      PREFETCH(&bins.fragments[i + to_next]);
      const SampleFragment f = bins.fragments[i];
      const uint place = f.place_and_mask & ((1u << PLACE_IN_TILE_BITS) - 1), block = place >> 8;
      if (!(*touched >> block & 1u)) {
        clear_block(tile, block, background);
        *touched |= 1u << block;
      }
      const SampleDepths depth = depths_of_fragment(f), held = depths[place];
      const SampleUints held_id = ids[place];
      const SampleInts covered = (f.place_and_mask >> PLACE_IN_TILE_BITS & SAMPLE_BITS) != 0;
      const SampleInts wins = covered & ((depth > held) | ((depth == held) & (f.id < held_id)));
      depths[place] = select(held, depth, wins);
      ids[place] = select(held_id, (SampleUints)(f.id), wins);
    }
    head = next;
  }
}

// What the planes hold of the blocks that fragments touched.
static inline void survey_blocks(Tile tile, uint touched, Blocks* blocks) {
  for (uint block = 0; block < LANES; block++) {
    if (!(touched >> block & 1u)) continue;
    Depths low = NEAREST_DEPTH, high = FARTHEST_DEPTH;
    for (int i = 0; i < BLOCK_VECTORS; i++) {
      const Depths held = tile.depth[block * BLOCK_VECTORS + i];
      low = min(low, held);
      high = max(high, held);
    }
    const int16 here = LANE == (int)block;
    blocks->min = select(blocks->min, (Depths)(min_depth(low)), here);
    blocks->max = select(blocks->max, (Depths)(max_depth(high)), here);
    blocks->content = select(blocks->content, (uint16)(PER_PIXEL), as_uint16(here));
  }
}

// ---- large triangles ------------------------------------------------------------------------------------------------

// Depths of a large triangle at the samples of a row, vector by vector, and which are not beyond the far plane. The row
// begins with column `column`.
#ifdef FORWARD_DEPTH
typedef struct {
  global const LargeTriangle* triangle;
  TileDepth origin;
  int column, row;
} SampleRow;
ALWAYS_INLINE SampleRow sample_row(global const LargeTriangle* t, TileDepth origin, int column, int row) {
  SampleRow samples;
  samples.triangle = t;
  samples.origin = origin;
  samples.column = column;
  samples.row = row;
  return samples;
}
ALWAYS_INLINE TwoFloats normalized_depth_of_samples(const SampleRow* r, int vector) {
  global const LargeTriangle* t = r->triangle;
  const long16 across = convert_long16((LANE / SAMPLES + r->column + vector * VECTOR_PIXELS) * SUBPIXELS +
                                       SAMPLE_X_OF_LANES * SAMPLE_UNIT),
               down = convert_long16(r->row * SUBPIXELS + SAMPLE_Y_OF_LANES * SAMPLE_UNIT);
  const SnappedEdges d = r->origin.edges;
  const long16 part_b = r->origin.part_b + across * d.d2y - down * d.d2x,
               part_c = r->origin.part_c + down * d.d1x - across * d.d1y;
  const TwoFloats a = two_floats((float16)(t->plane.a[0]), (float16)(t->plane.a[1]));
  const TwoFloats b = two_floats((float16)(t->plane.b[0]), (float16)(t->plane.b[1]));
  const TwoFloats c = two_floats((float16)(t->plane.c[0]), (float16)(t->plane.c[1]));
  return interpolated(a, b, c, from_longs(r->origin.area - part_b - part_c), from_longs(part_b), from_longs(part_c));
}
ALWAYS_INLINE Depths depths_of_samples(const SampleRow* r, int vector) {
  return min(max(key_of(normalized_depth_of_samples(r, vector)), (uint16)(r->triangle->plane.min_key)),
             (uint16)(r->triangle->plane.max_key));
}
ALWAYS_INLINE int16 samples_in_range(const SampleRow* r, int vector) {
  if (r->triangle->plane.in_range) return (int16)(-1);
  return normalized_depth_of_samples(r, vector).high >= 0.0f;
}
#else
typedef struct {
  float16 depth_dx, x, depth_at_0;  // x of the first vector, from the origin; where x is 0
} SampleRow;
ALWAYS_INLINE SampleRow sample_row(global const LargeTriangle* t, TileDepth origin, int column, int row) {
  SampleRow samples;
  samples.depth_dx = t->plane.depth_dx;
  samples.x = convert_float16(LANE / SAMPLES + (column - origin.column)) +
              convert_float16(SAMPLE_X_OF_LANES) * PIXELS_OF_SAMPLE_UNIT;
  samples.depth_at_0 = fma((float16)(t->plane.depth_dy),
                           (float)(row - origin.row) + convert_float16(SAMPLE_Y_OF_LANES) * PIXELS_OF_SAMPLE_UNIT,
                           (float16)(origin.depth));
  return samples;
}
ALWAYS_INLINE Depths depths_of_samples(const SampleRow* r, int vector) {
  return fma(r->depth_dx, r->x + (float)(vector * VECTOR_PIXELS), r->depth_at_0);
}
ALWAYS_INLINE int16 samples_in_range(const SampleRow* r, int vector) { return (int16)(-1); }
#endif

// The least and the greatest depth at the samples of boxes of pixels.
static inline DepthBounds depths_in_boxes(global const LargeTriangle* t, TileDepth origin, int16 left, int16 right,
                                          int16 top, int16 bottom) {
#ifdef FORWARD_DEPTH
  return depth_bounds(t, origin, left, right, top, bottom);
#else
  const float first = MIN_SAMPLE(SAMPLES) * PIXELS_OF_SAMPLE_UNIT, last = MAX_SAMPLE(SAMPLES) * PIXELS_OF_SAMPLE_UNIT;
  const float depth_dx = t->plane.depth_dx, depth_dy = t->plane.depth_dy;
  const float16 x0 = convert_float16(left - origin.column) + first, x1 = convert_float16(right - origin.column) + last;
  const float16 y0 = convert_float16(top - origin.row) + first, y1 = convert_float16(bottom - origin.row) + last;
  const float16 farthest_x = depth_dx < 0.0f ? x1 : x0, nearest_x = depth_dx < 0.0f ? x0 : x1;
  const float16 farthest_y = depth_dy < 0.0f ? y1 : y0, nearest_y = depth_dy < 0.0f ? y0 : y1;
  DepthBounds bounds;
  const float16 dx = depth_dx, dy = depth_dy, start = origin.depth;
  bounds.min = fma(dx, farthest_x, fma(dy, farthest_y, start));
  bounds.max = fma(dx, nearest_x, fma(dy, nearest_y, start));
  return bounds;
#endif
}

static inline void write_out_block(Tile tile, int block, uint content, global const LargeTriangle* large,
                                   Depth background) {
  if (content == CLEAR) {
    clear_block(tile, (uint)block, background);
    return;
  }
  global const LargeTriangle* t = &large[content];
  const TileDepth origin = depth_of_tile(t, tile.x, tile.y);
  for (int row = 0; row < TILE_BLOCK; row++) {
    const SampleRow samples = sample_row(t, origin, column_of(block), row_of(block) + row);
    for (int k = 0; k < SAMPLES; k++) {
      const int at = block * BLOCK_VECTORS + row * SAMPLES + k;
      tile.depth[at] = depths_of_samples(&samples, k);
      tile.id[at] = t->id;
    }
  }
}

// Puts the triangle's samples in the rows first..last of a block into the tile's planes: those in front of what is held
// or, without a depth test, all that it covers. Returns the least depth held there then.
ALWAYS_INLINE Depths draw_in_rows(Tile tile, const TileEdges* edges, global const LargeTriangle* t, TileDepth origin,
                                  int block, int first, int last, bool tests_depth) {
  const int column = column_of(block);
  int16 row_value[3];
  FOR_THREE(e)
  row_value[e] =
      edges->value[e] + edges->to_sample[e] + edges->step_x[e] * (LANE / SAMPLES + column) + edges->step_y[e] * first;
  const uint id = t->id;
  Depths min_held = NEAREST_DEPTH;
  for (int y = first; y <= last; y++) {
    int16 value[3];
    FOR_THREE(e) value[e] = row_value[e];
    const int row_at = block * BLOCK_VECTORS + (y - row_of(block)) * SAMPLES;
    const SampleRow samples = sample_row(t, origin, column, y);
    _Pragma("unroll(4)") for (int k = 0; k < SAMPLES; k++) {
      const int at = row_at + k;
      const Depths held = tile.depth[at], depth = depths_of_samples(&samples, k);
      const uint16 held_id = tile.id[at];
      int16 wins = ((value[0] | value[1] | value[2]) >= 0) & samples_in_range(&samples, k);
      if (tests_depth) wins &= (depth > held) | ((depth == held) & (id < held_id));
      const Depths kept = select(held, depth, wins);
      tile.depth[at] = kept;
      tile.id[at] = select(held_id, (uint16)(id), as_uint16(wins));
      min_held = min(min_held, kept);
      FOR_THREE(e) value[e] += edges->step_x[e] * VECTOR_PIXELS;
    }
    FOR_THREE(e) row_value[e] += edges->step_y[e];
  }
  return min_held;
}

#endif
