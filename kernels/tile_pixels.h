// Where a tile's pixels come from, surfaces, and where they go: halves of colours, in whole cache lines, and notes
// about blank blocks.

#ifndef MORPHCL_TILE_PIXELS_H
#define MORPHCL_TILE_PIXELS_H

#include "layout.h"
#include "light.h"
#include "shade.h"
#include "tables.h"
#include "tile.h"
#include "vector.h"

// Where a tile's pixels and its note are.
typedef struct {
  global uchar *red, *green, *blue, *alpha, *distance;  // of the first pixel
  size_t row_bytes;
  global uint* blank_blocks;
} TilePixels;

// The place of tile `tile_x` in the first of its rows.
ALWAYS_INLINE TilePixels pixels_of_tile(global const FrameConstants* frame, global uchar* first_row, uint tile_x) {
  TilePixels pixels;
  pixels.red = first_row + frame->color_offset[0] + tile_x * TILE * sizeof(half);
  pixels.green = first_row + frame->color_offset[1] + tile_x * TILE * sizeof(half);
  pixels.blue = first_row + frame->color_offset[2] + tile_x * TILE * sizeof(half);
  pixels.alpha = first_row + frame->color_offset[3] + tile_x * TILE * sizeof(half);
  pixels.distance = first_row + frame->depth_offset + tile_x * TILE * sizeof(float);
  pixels.row_bytes = frame->row_bytes;
  pixels.blank_blocks = (global uint*)(first_row + frame->notes_offset) + tile_x;
  return pixels;
}

// Sixteen halves, rounded to nearest even. Where the processor converts a whole vector it is asked to: vstore_half16
// goes by halves of vectors.
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

ALWAYS_INLINE RowColor row_color(Rgb color, float16 alpha) {
  RowColor halves;
  halves.red = to_halves(color.r);
  halves.green = to_halves(color.g);
  halves.blue = to_halves(color.b);
  halves.alpha = to_halves(alpha);
  return halves;
}

// The same where lanes of `shows` have the background of row y.
ALWAYS_INLINE RowColor over_background(RowColor color, global const FrameConstants* frame, int y, int16 shows) {
  const ushort4 behind = background_rows(frame)[y];
  const short16 lanes = convert_short16(shows);
  color.red = select(color.red, (ushort16)(behind.x), as_ushort16(lanes));
  color.green = select(color.green, (ushort16)(behind.y), as_ushort16(lanes));
  color.blue = select(color.blue, (ushort16)(behind.z), as_ushort16(lanes));
  color.alpha = select(color.alpha, (ushort16)(behind.w), as_ushort16(lanes));
  return color;
}

// Two neighbours at a time: what goes past the cache should fill its lines, of 64 bytes on most processors.
ALWAYS_INLINE void store_line(ushort16 left, ushort16 right, global uchar* out) {
  STREAM_STORE((ulong8)(as_ulong4(left), as_ulong4(right)), (global ulong8*)out);
}

ALWAYS_INLINE void store_colors(RowColor left, RowColor right, TilePixels pixels, int first, int row) {
  const size_t at = row * pixels.row_bytes + first * sizeof(half);
  store_line(left.red, right.red, pixels.red + at);
  store_line(left.green, right.green, pixels.green + at);
  store_line(left.blue, right.blue, pixels.blue + at);
  store_line(left.alpha, right.alpha, pixels.alpha + at);
}

// Sixteen columns of the rows of blocks that are shaded together. The surface is kept while its id stays.
typedef struct {
  uint content;
  global const LargeTriangle* triangle;  // a block of one triangle
  TileDepth origin;                      // where its depth in the tile is measured from
  BlockColumns columns;
  uint surface_id;  // NO_ID: the surface is still to be gathered
  Surface surface;
} Column;

ALWAYS_INLINE void start_block(Column* column, Tile tile, int first_column, uint content,
                               global const LargeTriangle* large) {
  column->content = content;
  if (content == CLEAR || content == PER_PIXEL) return;
  column->triangle = &large[content];
  column->origin = depth_of_tile(column->triangle, tile.x, tile.y);
  column->columns = block_columns(column->origin, first_column);
}

ALWAYS_INLINE Rgb color_of_primitive(const Shader* s, Column* column, uint id, Pixels p) {
  if (column->surface_id != id) {
    gather_surface(s, draw_of(s, id), lanes_of(id), true, &column->surface);
    column->surface_id = id;
  }
  return surface_color(s, &column->surface, p);
}

// Notes which blocks of the tile are `blank`, a bit a block, and returns those that are left as they are, as they were
// blank before: bits of even blocks stand for two neighbours.
//
// Where colours and distances are drawn by passes of their own, the first finds what was blank before in the lower half
// of the note, and puts its own into the upper half; the second leaves what both agree on.
ALWAYS_INLINE uint mark_blank_blocks(uint blank, global const FrameConstants* frame, TilePixels pixels) {
  const uint note = *pixels.blank_blocks, before = note & 0xffffu;
  const uint left_as_it_is = frame->keeps_blank_tiles ? blank & before : 0u;
  uint now = blank;
  if (frame->first_of_two)
    now = before | blank << LANES;
  else if (frame->second_of_two)
    now = blank & note >> LANES;
  *pixels.blank_blocks = frame->has_background ? 0u : now;
  return left_as_it_is & left_as_it_is >> 1;
}

// Whether so are all blocks of the strip that begins with block `first`.
ALWAYS_INLINE bool strip_is_left(uint left_as_it_is, int first) {
  const uint pairs = 1u | 1u << 2;
  return (left_as_it_is >> first & pairs) == pairs;
}

// A launch's tiles, in the order in which they are drawn: neighbours cost alike, and one thread draws a run of them.
typedef struct {
  uint first, count;
} TileRange;
ALWAYS_INLINE uint tile_at(uint place, TileRange tiles, global const FrameConstants* frame) {
  return tiles.first + place * frame->tile_step % tiles.count;
}

#endif
