// Exact coverage of triangles on the sub-pixel grid, shared by binning, tiles and shading.
//
// y grows downwards; a triangle is turned so that its doubled area is positive. A sample is covered when it is inside
// every edge or on a top or left edge, decided in integers: a shared edge is hit exactly once. One sample a pixel is
// its centre.

#ifndef MORPHCL_RASTER_H
#define MORPHCL_RASTER_H

#include "layout.h"
#include "vector.h"

// Of a pixel's samples, from its upper left, along both axes: sub-pixels.
#define SAMPLE_UNIT (1 << SAMPLE_UNIT_BITS)
#define FIRST_SAMPLE (HALF_PIXEL + MIN_SAMPLE(SAMPLES) * SAMPLE_UNIT)
#define LAST_SAMPLE (HALF_PIXEL + MAX_SAMPLE(SAMPLES) * SAMPLE_UNIT)

constant int sample_x[SAMPLES] = {SAMPLES_X}, sample_y[SAMPLES] = {SAMPLES_Y};  // in units of SAMPLE_UNIT

// First and last pixel of which a sample may lie in [low, high] sub-pixels.
#define FIRST_PIXEL(low) (((low) + (SUBPIXELS - 1 - LAST_SAMPLE)) >> SUBPIXEL_BITS)
#define LAST_PIXEL(high) (((high) - FIRST_SAMPLE) >> SUBPIXEL_BITS)

// The sub-pixel that a corner is snapped to.
#define SUBPIXEL_OF(corner) (((corner) + CORNER_UNITS / 2) >> CORNER_BITS)
#define SUBPIXELS_OF_CORNER_UNIT (1.0f / CORNER_UNITS)

// Sixteen triangles: corners in sub-pixels and in corner units, and bits of depth.
typedef struct {
  int16 x[3], y[3], corner_x[3], corner_y[3], depth[3];
} Triangles;

// Samples take depth from the plane through the sub-pixels, where the order of surfaces needs no care: many of them lie
// beside an edge.
#if SAMPLES > 1
#define CORNER_OF_PLANE(corner) (SUBPIXEL_OF(corner) * CORNER_UNITS)
#else
#define CORNER_OF_PLANE(corner) (corner)
#endif

// From corner a to corner i, sub-pixels.
#define ALL_ACROSS(t, i) (convert_float16((t)->corner_x[i] - (t)->corner_x[0]) * SUBPIXELS_OF_CORNER_UNIT)
#define ALL_DOWN(t, i) (convert_float16((t)->corner_y[i] - (t)->corner_y[0]) * SUBPIXELS_OF_CORNER_UNIT)

// From which value of all its edges' functions on a place that coverage's grid has in a triangle is inside its corners
// too: they are up to half a sub-pixel off the grid along both axes. `size`, `min_size`: the longest edge's and the
// shortest one's |dx| + |dy|. Edges of a tenth of a pixel say nothing about that. Where rounding to float moves the
// corners (those of 512 pixels), more is kept clear.
#define SHORT_EDGE 24
#define NO_MARGIN 0x3fffffff
static inline long margin_of_edges(long size, long min_size) {
  return min_size < SHORT_EDGE ? NO_MARGIN : min(size * 5 / 8 + 1 + (size * size >> 22), (long)NO_MARGIN);
}

// Of a large triangle, at most NO_MARGIN.
static inline long margin_of_large(const int dx[3], const int dy[3]) {
  long size[3];
  FOR_THREE(e) size[e] = (long)abs(dx[e]) + (long)abs(dy[e]);
  return margin_of_edges(max(size[0], max(size[1], size[2])), min(size[0], min(size[1], size[2])));
}

static inline int in_pixel_steps(long margin) { return (int)(margin + (SUBPIXELS - 1) >> SUBPIXEL_BITS); }

#if SAMPLES == 1
// Where coverage's grid has a place outside the corners, depth is that of its mirror image in the edge that it is
// beyond: two surfaces that meet there keep their order. This is the change of depth to there; 0 inside. Places and
// corners in corner units, change of depth per sub-pixel. `outside`: where that is.
ALWAYS_INLINE float16 to_mirror_image(const int16 x[3], const int16 y[3], int16 px, int16 py, float16 depth_dx,
                                      float16 depth_dy, int16* outside) {
  const float unit = SUBPIXELS_OF_CORNER_UNIT;
  float16 dx[3], dy[3], value[3];
  FOR_THREE(e) {
    const int next = e == 2 ? 0 : e + 1;
    dx[e] = convert_float16(x[next] - x[e]) * unit;
    dy[e] = convert_float16(y[next] - y[e]) * unit;
    value[e] =
        difference_of_products(dx[e], convert_float16(py - y[e]) * unit, dy[e], convert_float16(px - x[e]) * unit);
  }
  const int16 turned = value[0] + value[1] + value[2] < 0.0f;
  float16 change = 0.0f, farthest = 0.0f;
  *outside = 0;
  FOR_THREE(e) {
    const float16 way = value[e] / fma(dx[e], dx[e], dy[e] * dy[e]);  // to the edge, in units of its length
    const float16 square = way * value[e];                            // of the distance
    const int16 here = select(value[e] < 0.0f, value[e] > 0.0f, turned) & (square > farthest);
    change = select(change, -2.0f * way * difference_of_products(dx[e], depth_dy, dy[e], depth_dx), here);
    farthest = select(farthest, square, here);
    *outside |= here;
  }
  return change;
}
#endif

// A line along its longer axis, sub-pixels: how long it is where its ends are, and where they are snapped to; and from
// the ends to there.
typedef struct {
  float length, run, to_start, to_end;
} AlongLine;
static inline AlongLine along_line(int4 a, int4 b, bool steep) {
  const int start = steep ? a.y : a.x, end = steep ? b.y : b.x;
  AlongLine along;
  along.length = (float)(end - start) * SUBPIXELS_OF_CORNER_UNIT;
  along.run = (float)(SUBPIXEL_OF(end) - SUBPIXEL_OF(start));
  along.to_start = (float)(SUBPIXEL_OF(start) * CORNER_UNITS - start) * SUBPIXELS_OF_CORNER_UNIT;
  along.to_end = (float)(SUBPIXEL_OF(end) * CORNER_UNITS - end) * SUBPIXELS_OF_CORNER_UNIT;
  return along;
}

// Where the next entry of a tile goes. A chunk keeps, for every tile, a list of pages of PAGE entries; page 0 stands
// for "none". heads[tile] is the index behind the tile's newest entry, next[page] the page filled before it (layout.h).
typedef struct {
  global uint* heads;
  global uint* next;
  uint pages, capacity;
} PagedBins;

static inline uint next_entry(PagedBins* bins, uint tile) {
  uint at = bins->heads[tile];
  if ((at & (PAGE - 1)) == 0) {
    const uint page = bins->pages++;
    if (page < bins->capacity) bins->next[page] = at ? at / PAGE - 1 : 0;
    at = page * PAGE;
  }
  bins->heads[tile] = at + 1;
  return at;  // beyond capacity * PAGE: there is no room, the entry is only counted
}

// The first entry of the page that ends at `head`; 0 of none.
static inline uint first_of_page(uint head) { return head ? (head - 1) / PAGE * PAGE : 0; }

// The end of the page filled before that of `head`, or 0.
static inline uint head_before(global const uint* next, uint head) {
  const uint page = next[(head - 1) / PAGE];
  return page ? (page + 1) * PAGE : 0;
}

// E(p) = dx (py - vy) - dy (px - vx), less 1 where a sample on the edge belongs to the neighbour.
static inline long edge_value(int dx, int dy, int vx, int vy, int px, int py) {
  const int owns_edge = dy < 0 || (dy == 0 && dx > 0);
  return (long)dx * (py - vy) - (long)dy * (px - vx) - (owns_edge ? 0 : 1);
}

#endif
