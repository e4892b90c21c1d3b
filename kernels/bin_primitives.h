// bin_primitives: set up triangles and lines and sort them into tiles.
//
// In:  vertices, indices, draws, clipped primitives.
// Out, one set a chunk: fragments {depth, id, place in the tile} of lines and of triangles over at most 8 x 8 pixel
//      centres, already rasterised; large triangles, set up, with an entry in every tile they may touch; both in pages.
//      chunk_status[chunk]: how much room the chunk needed. What found no room raises the flag `overflow` and the frame
//      is binned again.
// Steps: 1 fetch 16 triangles, cull, classify; 2 rasterise the small ones, one lane a triangle; 3 set up the large
//        ones; 4 lines; 5 what clipping left of this chunk's primitives, as large triangles.
// One work-item walks a chunk of primitive groups, near draws first: what they hide is then left out in the tiles at
// little cost. Nothing but the time depends on the order of entries.

#ifndef MORPHCL_BIN_PRIMITIVES_H
#define MORPHCL_BIN_PRIMITIVES_H

#include "depth_format.h"
#include "layout.h"
#include "raster.h"
#include "tables.h"
#include "vector.h"

// A chunk's bins while they are filled.
typedef struct {
  PagedBins fragments, entries;
  global Fragment* fragments_of_pixels;
  global ushort* fragment_places;
  global uint* entry_triangles;
  global LargeTriangle* large;
  uint large_count, large_capacity;
  int width, height, tiles_x;
  global const FrameConstants* frame;
} Bins;

#if SAMPLES == 1
static inline void add_fragment(Bins* bins, int x, int y, uint depth_bits, uint id) {
  const uint at = next_entry(&bins->fragments, (uint)((y / TILE) * bins->tiles_x + x / TILE));
  if (at >= bins->fragments.capacity * PAGE) return;
  bins->fragments_of_pixels[at] = ((ulong)depth_bits << 32) | id;
  bins->fragment_places[at] = (ushort)((y % TILE) * TILE + x % TILE);
}
#else
static inline void add_fragment(Bins* bins, int x, int y, uint depth_bits, float depth_dx, float depth_dy, uint mask,
                                uint id) {
  const uint at = next_entry(&bins->fragments, (uint)((y / TILE) * bins->tiles_x + x / TILE));
  if (at >= bins->fragments.capacity * PAGE) return;
  SampleFragment f;
  f.depth = depth_bits;
  f.id = id;
  f.depth_dx = depth_dx;
  f.depth_dy = depth_dy;
  const uint block = (uint)(y % TILE / TILE_BLOCK * TILE_BLOCKS + x % TILE / TILE_BLOCK);
  f.place_and_mask = mask << PLACE_IN_TILE_BITS | block << 8 | (uint)(y % TILE_BLOCK) << 4 | (uint)(x % TILE_BLOCK);
  bins->fragments_of_pixels[at] = f;
}
#endif

// ---- large triangles ------------------------------------------------------------------------------------------------

static inline void bin_large_triangle(Bins* bins, int4 a, int4 b, int4 c, uint id, bool double_sided) {
  const long area = (long)(SUBPIXEL_OF(b.x) - SUBPIXEL_OF(a.x)) * (SUBPIXEL_OF(c.y) - SUBPIXEL_OF(a.y)) -
                    (long)(SUBPIXEL_OF(c.x) - SUBPIXEL_OF(a.x)) * (SUBPIXEL_OF(b.y) - SUBPIXEL_OF(a.y));
  if (area == 0 || (area < 0 && !double_sided)) return;
  if (area < 0) {
    const int4 swapped = b;
    b = c;
    c = swapped;
  }
  turn_for_depth(&a, &b, &c);
  const int vx[3] = {SUBPIXEL_OF(a.x), SUBPIXEL_OF(b.x), SUBPIXEL_OF(c.x)},
            vy[3] = {SUBPIXEL_OF(a.y), SUBPIXEL_OF(b.y), SUBPIXEL_OF(c.y)};
  const int first_x = max(FIRST_PIXEL(min(vx[0], min(vx[1], vx[2]))), 0),
            first_y = max(FIRST_PIXEL(min(vy[0], min(vy[1], vy[2]))), 0);
  const int last_x = min(LAST_PIXEL(max(vx[0], max(vx[1], vx[2]))), bins->width - 1),
            last_y = min(LAST_PIXEL(max(vy[0], max(vy[1], vy[2]))), bins->height - 1);
  if (first_x > last_x || first_y > last_y) return;

  LargeTriangle t;
  t.x[0] = CORNER_OF_PLANE(a.x);
  t.x[1] = CORNER_OF_PLANE(b.x);
  t.x[2] = CORNER_OF_PLANE(c.x);
  t.y[0] = CORNER_OF_PLANE(a.y);
  t.y[1] = CORNER_OF_PLANE(b.y);
  t.y[2] = CORNER_OF_PLANE(c.y);
  t.id = id;
  const int dx[3] = {vx[1] - vx[0], vx[2] - vx[1], vx[0] - vx[2]},
            dy[3] = {vy[1] - vy[0], vy[2] - vy[1], vy[0] - vy[2]};
  const long margin = SAMPLES > 1 ? 0 : margin_of_large(dx, dy);
  set_depth_plane(&t, a, b, c, bins->frame);
  keep_margin(&t, margin);
  const uint number = bins->large_count++;
  if (number >= bins->large_capacity) return;
  bins->large[number] = t;

  const long reach = (TILE - 1) * SUBPIXELS + (LAST_SAMPLE - FIRST_SAMPLE);
  for (int tile_y = first_y / TILE; tile_y <= last_y / TILE; tile_y++)
    for (int tile_x = first_x / TILE; tile_x <= last_x / TILE; tile_x++) {
      const int px = tile_x * TILE * SUBPIXELS + FIRST_SAMPLE, py = tile_y * TILE * SUBPIXELS + FIRST_SAMPLE;
      bool misses = false, covers = true;
      FOR_THREE(e) {
        const long value = edge_value(dx[e], dy[e], vx[e], vy[e], px, py);
        misses |= value + max(-dy[e], 0) * reach + max(dx[e], 0) * reach < 0;
        covers &= value + min(-dy[e], 0) * reach + min(dx[e], 0) * reach >= margin;
      }
      if (misses) continue;
      const uint at = next_entry(&bins->entries, (uint)(tile_y * bins->tiles_x + tile_x));
      if (at < bins->entries.capacity * PAGE) bins->entry_triangles[at] = number | (covers ? ENTIRE_TILE : 0u);
    }
}

// ---- lines ----------------------------------------------------------------------------------------------------------

static inline long floor_divide(long numerator, long denominator) {  // denominator > 0
  const long quotient = numerator / denominator;
  return quotient * denominator > numerator ? quotient - 1 : quotient;
}

// Along its longer axis, from the end that comes first there, and across; sub-pixels.
typedef struct {
  bool steep;
  int start, stop, across, rise;
  LineDepth depth;
} ScreenLine;
static inline ScreenLine screen_line(int4 a, int4 b, global const FrameConstants* frame) {
  const int ax = SUBPIXEL_OF(a.x), ay = SUBPIXEL_OF(a.y), bx = SUBPIXEL_OF(b.x), by = SUBPIXEL_OF(b.y);
  ScreenLine line;
  line.steep = abs(by - ay) > abs(bx - ax);
  const bool turned = line.steep ? by < ay : bx < ax;
  const int first = line.steep ? ay : ax, second = line.steep ? by : bx;
  const int beside_first = line.steep ? ax : ay, beside_second = line.steep ? bx : by;
  line.start = turned ? second : first;
  line.stop = turned ? first : second;
  line.across = turned ? beside_second : beside_first;
  line.rise = turned ? beside_first - beside_second : beside_second - beside_first;
  line.depth = turned ? line_depth(b, a, line.steep, frame) : line_depth(a, b, line.steep, frame);
  return line;
}

// What a wide line leaves at a pixel.
static inline void add_line_fragments(Bins* bins, bool steep, int along, int other, const LineDepth* depth, long offset,
                                      long run, uint mask, uint id) {
  const int x = steep ? other : along, y = steep ? along : other;
  uint depth_bits;
#if SAMPLES == 1
  if (depth_on_line(depth, offset, run, &depth_bits)) add_fragment(bins, x, y, depth_bits, id);
#elif defined(FORWARD_DEPTH)
  for (int s = 0; s < SAMPLES; s++) {
    const long sample_offset = offset + (steep ? sample_y[s] : sample_x[s]) * SAMPLE_UNIT;
    if (mask >> s & 1u && depth_on_line(depth, sample_offset, run, &depth_bits))
      add_fragment(bins, x, y, depth_bits, 0.0f, 0.0f, 1u << s, id);
  }
#else
  depth_on_line(depth, offset, run, &depth_bits);
  const float slope = depth->change * (float)SUBPIXELS / (float)run;
  add_fragment(bins, x, y, depth_bits, steep ? 0.0f : slope, steep ? slope : 0.0f, mask, id);
#endif
}

#if SAMPLES == 1
// One pixel for each column (or, in steep lines, row) whose centre lies in the half-open run from the first end to the
// last; the pixel is the one the exact line passes through there.
static inline void bin_thin_line(Bins* bins, int4 a, int4 b, uint id) {
  const ScreenLine line = screen_line(a, b, bins->frame);
  const bool steep = line.steep;
  const int start = line.start, stop = line.stop, across = line.across;
  const long run = stop - start, rise = line.rise;
  if (run == 0) return;
  const int limit = steep ? bins->height : bins->width, across_limit = steep ? bins->width : bins->height;
  const int first = max(FIRST_PIXEL(start), 0), last = min(LAST_PIXEL(stop - 1), limit - 1);
  for (int along = first; along <= last; along++) {
    const long offset = along * SUBPIXELS + HALF_PIXEL - start;
    const long other = floor_divide(across * run + rise * offset, run * SUBPIXELS);
    if (other < 0 || other >= across_limit) continue;
    uint depth_bits;
    if (!depth_on_line(&line.depth, offset, run, &depth_bits)) continue;
    add_fragment(bins, steep ? (int)other : along, steep ? along : (int)other, depth_bits, id);
  }
}

#endif

// Half of what a line covers across its longer axis, in sub-pixels.
static inline long half_thickness(long run, long rise, uint width) {
  const float along = (float)run, across = (float)rise;
  const float length = sqrt(fma(across, across, along * along));
  return max((int)(0.5f * (float)width * (length / along) + 0.5f), 1);
}

// A parallelogram: as long as the line along its longer axis, half open, and half_thickness() to both sides of it.
static inline void bin_wide_line(Bins* bins, int4 a, int4 b, uint width, uint id) {
  const ScreenLine line = screen_line(a, b, bins->frame);
  const bool steep = line.steep;
  const int start = line.start, stop = line.stop, across = line.across;
  const long run = stop - start, rise = line.rise;
  if (run == 0) return;
  const long thickness = half_thickness(run, rise, width) * run;
  const int limit = steep ? bins->height : bins->width, across_limit = steep ? bins->width : bins->height;
  // Of a pixel to the one next to it the line moves by a pixel across at most.
  const long reach = thickness / run / SUBPIXELS + 2;
  const int first = max(FIRST_PIXEL(start), 0), last = min(LAST_PIXEL(stop), limit - 1);
  for (int along = first; along <= last; along++) {
    const long centre_offset = along * SUBPIXELS + HALF_PIXEL - start;
    const long middle = floor_divide(across * run + rise * centre_offset, run * SUBPIXELS);
    const int low = (int)clamp(middle - reach, 0L, (long)across_limit),
              high = (int)clamp(middle + reach, -1L, (long)across_limit - 1);
    for (int other = low; other <= high; other++) {
      uint mask = 0;
      for (int s = 0; s < SAMPLES; s++) {
        const int along_sample = (steep ? sample_y[s] : sample_x[s]) * SAMPLE_UNIT,
                  across_sample = (steep ? sample_x[s] : sample_y[s]) * SAMPLE_UNIT;
        const long offset = centre_offset + along_sample;
        const long beside = run * (other * SUBPIXELS + HALF_PIXEL + across_sample - across) - rise * offset;
        if (offset >= 0 && offset < run && beside >= -thickness && beside < thickness) mask |= 1u << s;
      }
      if (mask) add_line_fragments(bins, steep, along, other, &line.depth, centre_offset, run, mask, id);
    }
  }
}

static inline void bin_line(Bins* bins, int4 a, int4 b, uint width, uint id) {
#if SAMPLES == 1
  if (width == SUBPIXELS) {
    bin_thin_line(bins, a, b, id);
    return;
  }
#endif
  bin_wide_line(bins, a, b, width, id);
}

// ---- small triangles ------------------------------------------------------------------------------------------------

// Edge value of each lane, less 1 where a centre on the edge belongs to the neighbour.
static inline int16 edge_values(int16 dx, int16 dy, int16 vx, int16 vy, int16 px, int16 py) {
  const int16 owns_edge = (dy < 0) | ((dy == 0) & (dx > 0));
  return dx * (py - vy) - dy * (px - vx) - (1 + owns_edge);
}

#if SAMPLES == 1
#include "small_triangles.h"
#else
#include "small_triangle_samples.h"
#endif

static inline void bin_triangle_group(Bins* bins, global const DrawConstants* draw, global const uint* indices,
                                      global const int4* vertices, uint first, uint first_id) {
  // Front faces get a positive area: on the screen y points down, so the second and third corner change places.
  const bool mirrored = (draw->flags & DRAW_MIRRORED) != 0, double_sided = (draw->flags & DRAW_DOUBLE_SIDED) != 0;
  global const uint* corner_a = indices + draw->indices + first;
  global const uint* corner_b = corner_a + (mirrored ? 1 : 2) * draw->index_pitch;
  global const uint* corner_c = corner_a + (mirrored ? 2 : 1) * draw->index_pitch;
  global const int4* records = vertices + (size_t)draw->first_vertex_group * LANES;
  Triangles t;
  int16 unused;
  GATHER_RECORDS(records, corner_a, t.corner_x[0], t.corner_y[0], t.depth[0], unused)
  GATHER_RECORDS(records, corner_b, t.corner_x[1], t.corner_y[1], t.depth[1], unused)
  GATHER_RECORDS(records, corner_c, t.corner_x[2], t.corner_y[2], t.depth[2], unused)
  const int16 clipped = (t.corner_x[0] == OUTSIDE) | (t.corner_x[1] == OUTSIDE) | (t.corner_x[2] == OUTSIDE);
  FOR_THREE(i) {
    t.x[i] = SUBPIXEL_OF(t.corner_x[i]);
    t.y[i] = SUBPIXEL_OF(t.corner_y[i]);
    t.corner_x[i] = CORNER_OF_PLANE(t.corner_x[i]);
    t.corner_y[i] = CORNER_OF_PLANE(t.corner_y[i]);
  }
  const int16 low_x = min(t.x[0], min(t.x[1], t.x[2])), high_x = max(t.x[0], max(t.x[1], t.x[2]));
  const int16 low_y = min(t.y[0], min(t.y[1], t.y[2])), high_y = max(t.y[0], max(t.y[1], t.y[2]));
  const int16 first_x = FIRST_PIXEL(low_x), first_y = FIRST_PIXEL(low_y);
  const int16 last_x = min(LAST_PIXEL(high_x), (int16)(bins->width - 1)),
              last_y = min(LAST_PIXEL(high_y), (int16)(bins->height - 1));
  const int16 seen = ~clipped & (max(first_x, (int16)(0)) <= last_x) & (max(first_y, (int16)(0)) <= last_y);
  // Up to 64 pixels wide and high, areas and edge values fit 32 bits.
  const int16 fits_int = ((high_x - low_x) < TILE * SUBPIXELS) & ((high_y - low_y) < TILE * SUBPIXELS);
  int16 area = (t.x[1] - t.x[0]) * (t.y[2] - t.y[0]) - (t.x[2] - t.x[0]) * (t.y[1] - t.y[0]);
  const int16 faces = double_sided ? area != 0 : area > 0;
  const int16 small =
      seen & fits_int & faces & ((last_x - first_x) < SMALL_PIXELS) & ((last_y - first_y) < SMALL_PIXELS);
  const int16 large = seen & ~small & (faces | ~fits_int);

  if (any_lane(small)) {
    Triangles turned = t;
    if (double_sided) {
      const int16 back = area < 0;
      for (int i = 1; i < 3; i++) {
        turned.x[i] = select(t.x[i], t.x[3 - i], back);
        turned.y[i] = select(t.y[i], t.y[3 - i], back);
        turned.corner_x[i] = select(t.corner_x[i], t.corner_x[3 - i], back);
        turned.corner_y[i] = select(t.corner_y[i], t.corner_y[3 - i], back);
        turned.depth[i] = select(t.depth[i], t.depth[3 - i], back);
      }
      area = select(area, -area, back);
    }
    rasterize_small_triangles(bins, turned, area, small, first_x, first_y, last_x, last_y, first_id);
  }
  FOR_EACH_LANE(lane, large)
  bin_large_triangle(bins, records[corner_a[lane]], records[corner_b[lane]], records[corner_c[lane]],
                     first_id + (uint)lane * PIECES, double_sided);
}

static inline void bin_line_group(Bins* bins, global const DrawConstants* draw, global const uint* indices,
                                  global const int4* vertices, uint first, uint first_id) {
  global const uint* start = indices + draw->indices + first;
  global const int4* records = vertices + (size_t)draw->first_vertex_group * LANES;
  for (uint lane = 0; lane < LANES; lane++) {
    const int4 a = records[start[lane]], b = records[start[lane + draw->index_pitch]];
    if (a.x != OUTSIDE && b.x != OUTSIDE) bin_line(bins, a, b, draw->line_width, first_id + lane * PIECES);
  }
}

static inline void bin_clipped(Bins* bins, global const DrawConstants* draw, global const int4* corners, uint count,
                               uint first_id) {
  if (draw->flags & DRAW_LINES) {
    if (count == 2) bin_line(bins, corners[0], corners[1], draw->line_width, first_id + 1);
    return;
  }
  const uint second = draw->flags & DRAW_MIRRORED ? 0 : 1;
  for (uint i = 1; i + 1 < count; i++)
    bin_large_triangle(bins, corners[0], corners[i + second], corners[i + 1 - second], first_id + i,
                       (draw->flags & DRAW_DOUBLE_SIDED) != 0);
}

// Whose lists the next primitives go into.
ALWAYS_INLINE void choose_lists(Bins* bins, ChunkBins own, global const DrawConstants* draw) {
  const bool blended = (draw->flags & DRAW_BLENDED) != 0;
  bins->fragments.heads = blended ? own.blended_fragment_heads : own.fragment_heads;
  bins->entries.heads = blended ? own.blended_entry_heads : own.entry_heads;
}

static inline Bins empty_bins(ChunkBins own, global const FrameConstants* frame) {
  Bins bins;
  bins.fragments.heads = own.fragment_heads;
  bins.fragments.next = own.fragment_next;
  bins.fragments.pages = 1;
  bins.fragments.capacity = frame->fragment_pages;
  bins.entries.heads = own.entry_heads;
  bins.entries.next = own.entry_next;
  bins.entries.pages = 1;
  bins.entries.capacity = frame->entry_pages;
  bins.fragments_of_pixels = own.fragments;
  bins.fragment_places = own.fragment_places;
  bins.entry_triangles = own.entry_triangles;
  bins.large = own.large;
  bins.large_count = 0;
  bins.large_capacity = frame->large_capacity;
  bins.width = frame->width;
  bins.height = frame->height;
  bins.tiles_x = frame->tiles_x;
  bins.frame = frame;
  for (int tile = 0; tile < frame->tiles_x * frame->tiles_y; tile++) {
    bins.fragments.heads[tile] = 0;
    bins.entries.heads[tile] = 0;
    if (!frame->blends) continue;
    own.blended_fragment_heads[tile] = 0;
    own.blended_entry_heads[tile] = 0;
  }
  return bins;
}

COMPILED_ONCE void bin_chunk(uint chunk, global const FrameConstants* restrict frame,
                             global const DrawConstants* restrict draws, global const uint* restrict indices,
                             global const int4* restrict vertices, global const ClippedPrimitive* restrict clipped,
                             global Fragment* restrict fragments, global BinsHeader* restrict shared_bins,
                             global LargeTriangle* restrict large) {
  const ChunkBins own = bins_of_chunk(chunk, frame, shared_bins, fragments, large);
  Bins bins = empty_bins(own, frame);
  const GroupRange groups = primitive_groups_of(chunk, frame);
  for (uint order = groups.first; order < groups.end; order++) {
    global const DrawConstants* draw = &draws[draw_in_order(draws, frame)[order]];
    const uint group = order - draw->first_in_order;
    const uint first_id = (draw->first_primitive_group + group) * LANES * PIECES;
    if (frame->blends) choose_lists(&bins, own, draw);
    if (draw->flags & DRAW_LINES)
      bin_line_group(&bins, draw, indices, vertices, group * LANES, first_id);
    else
      bin_triangle_group(&bins, draw, indices, vertices, group * LANES, first_id);
  }

  global ChunkStatus* status = chunk_status(shared_bins, frame);
  bool overflows = false;
  if (frame->clips) {
    uint first_slot = 0, total = 0;
    for (uint i = 0; i < frame->chunk_count; i++) {
      if (i == chunk) first_slot = total;
      total += status[i].clipped;
    }
    const uint end_slot = min(first_slot + status[chunk].clipped, frame->clip_capacity);
    for (uint slot = first_slot; slot < end_slot; slot++) {
      const uint source = clipped[slot].source;
      global const DrawConstants* draw = &draws[draw_of_primitive_group(draws, frame)[source / LANES]];
      if (frame->blends) choose_lists(&bins, own, draw);
      bin_clipped(&bins, draw, vertices + frame->first_clip_vertex + slot * CLIP_VERTICES, clipped[slot].count,
                  source * PIECES);
    }
    overflows = total > frame->clip_capacity;
  }
  status[chunk].fragment_pages = bins.fragments.pages;
  status[chunk].entry_pages = bins.entries.pages;
  status[chunk].large = bins.large_count;
  overflows |= bins.fragments.pages > frame->fragment_pages || bins.entries.pages > frame->entry_pages ||
               bins.large_count > frame->large_capacity;
  if (overflows) atomic_or(&shared_bins->overflow, 1u);
}

#endif
