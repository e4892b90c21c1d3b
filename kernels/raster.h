// Exact coverage of triangles on the sub-pixel grid, shared by binning, tiles and shading.
//
// y grows downwards; a triangle is turned so that its doubled area is positive. A sample is covered when it is inside
// every edge or on a top or left edge, decided in integers: a shared edge is hit exactly once. One sample a pixel is
// its centre.

#ifndef MORPHCL_RASTER_H
#define MORPHCL_RASTER_H

#include "layout.h"

// Of a pixel's samples, from its upper left, along both axes: sub-pixels.
#define SAMPLE_UNIT (1 << SAMPLE_UNIT_BITS)
#define FIRST_SAMPLE (HALF_PIXEL + MIN_SAMPLE(SAMPLES) * SAMPLE_UNIT)
#define LAST_SAMPLE (HALF_PIXEL + MAX_SAMPLE(SAMPLES) * SAMPLE_UNIT)

constant int sample_x[SAMPLES] = {SAMPLES_X}, sample_y[SAMPLES] = {SAMPLES_Y};  // in units of SAMPLE_UNIT

// First and last pixel of which a sample may lie in [low, high] sub-pixels.
#define FIRST_PIXEL(low) (((low) + (SUBPIXELS - 1 - LAST_SAMPLE)) >> SUBPIXEL_BITS)
#define LAST_PIXEL(high) (((high) - FIRST_SAMPLE) >> SUBPIXEL_BITS)

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
