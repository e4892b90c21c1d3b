// Depth buffers that span near to far: float, and fixed point of 16, 24 and 32 bits. The functions are those of
// reversed_depth.h, which is the faster one.
//
// A vertex record keeps the distance along the view axis. Normalized depth is 1 on the near plane and 0 on the far one:
//   (q - depth_far) * depth_scale,  q = near / distance and depth_far = near / far; parallel: minus the distances
// It is affine on the screen. The corners' values are taken along the plane through where they are to the sub-pixels
// that they are snapped to, and interpolated in two floats by the exact doubled areas opposite to the corners, each
// times its corner's normalized depth over the whole area: no cancellation, about 2^-40 of the largest. What is stored
// is a *key*:
//   fixed   normalized depth times the number of steps, rounded to nearest
//   float   the bits of 1 less those of 1 - normalized depth, rounded to float: neighbouring floats have neighbouring
//           keys
// Keys lie between those of the corners where they are. What is beyond the far plane, of negative normalized depth, is
// not drawn.

#ifndef MORPHCL_FORWARD_DEPTH_H
#define MORPHCL_FORWARD_DEPTH_H

#include "layout.h"
#include "raster.h"
#include "two_float.h"
#include "vector.h"

typedef uint Depth;  // a key; larger is nearer
typedef uint16 Depths;
#define FARTHEST_DEPTH 0u
#define NEAREST_DEPTH 0xffffffffu

// The number of steps as two floats. (Of 32 bits it is no float.)
#if DEPTH_FORMAT == DEPTH_FIXED_16
#define DEPTH_STEPS 65535.0f
#define DEPTH_STEPS_REST 0.0f
#elif DEPTH_FORMAT == DEPTH_FIXED_24
#define DEPTH_STEPS 16777215.0f
#define DEPTH_STEPS_REST 0.0f
#else
#define DEPTH_STEPS 4294967296.0f
#define DEPTH_STEPS_REST (-1.0f)
#endif
#define BITS_OF_1 0x3f800000u

static inline Depth min_depth(Depths depths) {
  const uint8 a = min(depths.lo, depths.hi);
  const uint4 b = min(a.lo, a.hi);
  const uint2 c = min(b.lo, b.hi);
  return min(c.x, c.y);
}
static inline Depth max_depth(Depths depths) {
  const uint8 a = max(depths.lo, depths.hi);
  const uint4 b = max(a.lo, a.hi);
  const uint2 c = max(b.lo, b.hi);
  return max(c.x, c.y);
}
static inline Depth depth_from_bits(uint bits) { return bits; }
static inline Depth background_depth(global const FrameConstants* frame) { return 0; }

// ---- normalized depth and keys
// ----------------------------------------------------------------------------------------

static inline TwoFloats normalized_depth_of(float16 distance, global const FrameConstants* frame) {
  TwoFloats q = two_floats(-distance, (float16)0.0f);
  if (!frame->camera.parallel) {
    const float16 near = frame->camera.near, quotient = near / distance;
    q = two_floats(quotient, fma(-quotient, distance, near) / distance);
  }
  const TwoFloats far = two_floats((float16)(frame->camera.depth_far[0]), (float16)(frame->camera.depth_far[1]));
  const TwoFloats scale = two_floats((float16)(frame->camera.depth_scale[0]), (float16)(frame->camera.depth_scale[1]));
  TwoFloats normalized_depth = product_of(difference_of(q, far), scale);
  const int16 too_far = ~(normalized_depth.high >= -MAX_NORMALIZED_DEPTH);
  normalized_depth.high = select(normalized_depth.high, (float16)(-MAX_NORMALIZED_DEPTH), too_far);
  normalized_depth.low = select(normalized_depth.low, (float16)(0.0f), too_far);
  return normalized_depth;
}

// The key of a normalized depth up to 1; what is negative gets that of 0.
static inline uint16 key_of(TwoFloats normalized_depth) {
#if DEPTH_FORMAT == DEPTH_FLOAT
  const TwoFloats from_near = two_sum((float16)(1.0f), -normalized_depth.high);
  float16 depth = from_near.high + (from_near.low - normalized_depth.low);
  depth = select(depth, (float16)(0.0f), depth < 0.0f);
  depth = select(depth, (float16)(1.0f), depth > 1.0f);
  return BITS_OF_1 - as_uint16(depth);
#else
  const TwoFloats steps = product_of(normalized_depth, two_floats((float16)(DEPTH_STEPS), (float16)(DEPTH_STEPS_REST)));
  float16 high = select(steps.high, (float16)(0.0f), steps.high < 0.0f);
  high = select(high, (float16)(DEPTH_STEPS), high > DEPTH_STEPS);
  const float16 whole = rint(high);
  const long16 key = convert_long16(whole) + convert_long16(rint((high - whole) + steps.low));
  const long max_key = (long)DEPTH_STEPS + (long)DEPTH_STEPS_REST;
  return convert_uint16(min(max(key, (long16)(0)), (long16)(max_key)));
#endif
}

// Normalized depth of a key, from 0 to 1.
ALWAYS_INLINE float16 normalized_depth_of_key(Depths key) {
#if DEPTH_FORMAT == DEPTH_FLOAT
  return 1.0f - as_float16(BITS_OF_1 - key);
#else
  return convert_float16(key) / (DEPTH_STEPS);
#endif
}

// What eye_distance() takes.
ALWAYS_INLINE float16 decoded_depth(Depths key, global const FrameConstants* frame) {
  return fma(normalized_depth_of_key(key), (float16)(frame->camera.depth_span), (float16)(frame->camera.depth_far[0]));
}

typedef struct {
  TwoFloats a, b, c;  // of the corners, over the doubled area
  uint16 min_key, max_key;
  int16 in_range;  // no part is beyond the far plane
} NormalizedDepthPlanes;

// b - a, rounded to a float.
ALWAYS_INLINE float16 rounded_difference(TwoFloats b, TwoFloats a) { return (b.high - a.high) + (b.low - a.low); }

// The plane's value at the sub-pixel that corner i is snapped to. dx, dy: change per sub-pixel.
ALWAYS_INLINE TwoFloats at_subpixel(TwoFloats corner, const Triangles* t, int i, float16 dx, float16 dy) {
  const float16 across = convert_float16(t->x[i] * CORNER_UNITS - t->corner_x[i]) * SUBPIXELS_OF_CORNER_UNIT,
                down = convert_float16(t->y[i] * CORNER_UNITS - t->corner_y[i]) * SUBPIXELS_OF_CORNER_UNIT;
  const float16 change = fma(dx, across, dy * down), max_change = MAX_NORMALIZED_DEPTH;
  return sum_of(corner, two_floats(min(max(change, -max_change), max_change), (float16)(0.0f)));
}

static inline NormalizedDepthPlanes normalized_depth_planes(const Triangles* t, TwoFloats area,
                                                            global const FrameConstants* frame) {
  const TwoFloats a = normalized_depth_of(as_float16(t->depth[0]), frame),
                  b = normalized_depth_of(as_float16(t->depth[1]), frame),
                  c = normalized_depth_of(as_float16(t->depth[2]), frame);
  const uint16 key_a = key_of(a), key_b = key_of(b), key_c = key_of(c);
  NormalizedDepthPlanes planes;
  planes.min_key = min(key_a, min(key_b, key_c));
  planes.max_key = max(key_a, max(key_b, key_c));
  planes.in_range = (a.high >= 0.0f) & (b.high >= 0.0f) & (c.high >= 0.0f);
  const float16 d1x = ALL_ACROSS(t, 1), d1y = ALL_DOWN(t, 1), d2x = ALL_ACROSS(t, 2), d2y = ALL_DOWN(t, 2);
  const float16 depth1 = rounded_difference(b, a), depth2 = rounded_difference(c, a);
  const float16 true_area = difference_of_products(d1x, d2y, d2x, d1y);
  const float16 inverse_area = select(1.0f / true_area, (float16)(0.0f), true_area == 0.0f);
  const float16 dx = difference_of_products(d2y, depth1, d1y, depth2) * inverse_area,
                dy = difference_of_products(d1x, depth2, d2x, depth1) * inverse_area;
  planes.a = quotient_of(at_subpixel(a, t, 0, dx, dy), area);
  planes.b = quotient_of(at_subpixel(b, t, 1, dx, dy), area);
  planes.c = quotient_of(at_subpixel(c, t, 2, dx, dy), area);
  return planes;
}

static inline TwoFloats interpolated(TwoFloats a, TwoFloats b, TwoFloats c, TwoFloats part_a, TwoFloats part_b,
                                     TwoFloats part_c) {
  return sum_of(product_of(part_a, a), sum_of(product_of(part_b, b), product_of(part_c, c)));
}

// ---- large triangles ------------------------------------------------------------------------------------------------

static inline void turn_for_depth(int4* a, int4* b, int4* c) {}

// Edges from corner a, sub-pixels.
typedef struct {
  int d1x, d1y, d2x, d2y;
} SnappedEdges;
ALWAYS_INLINE SnappedEdges snapped_edges(const int* x, const int* y) {
  SnappedEdges edges;
  edges.d1x = SUBPIXEL_OF(x[1]) - SUBPIXEL_OF(x[0]);
  edges.d1y = SUBPIXEL_OF(y[1]) - SUBPIXEL_OF(y[0]);
  edges.d2x = SUBPIXEL_OF(x[2]) - SUBPIXEL_OF(x[0]);
  edges.d2y = SUBPIXEL_OF(y[2]) - SUBPIXEL_OF(y[0]);
  return edges;
}

static inline void set_depth_plane(LargeTriangle* t, int4 a, int4 b, int4 c, global const FrameConstants* frame) {
  Triangles all;
  FOR_THREE(i) {
    all.corner_x[i] = t->x[i];
    all.corner_y[i] = t->y[i];
    all.x[i] = SUBPIXEL_OF(t->x[i]);
    all.y[i] = SUBPIXEL_OF(t->y[i]);
  }
  all.depth[0] = a.z;
  all.depth[1] = b.z;
  all.depth[2] = c.z;
  const SnappedEdges d = snapped_edges(t->x, t->y);
  const long area = (long)d.d1x * d.d2y - (long)d.d2x * d.d1y;
  const NormalizedDepthPlanes planes = normalized_depth_planes(&all, from_longs((long16)(area)), frame);
  DepthPlane* p = &t->plane;
  p->a[0] = planes.a.high.s0;
  p->a[1] = planes.a.low.s0;
  p->b[0] = planes.b.high.s0;
  p->b[1] = planes.b.low.s0;
  p->c[0] = planes.c.high.s0;
  p->c[1] = planes.c.low.s0;
  p->min_key = planes.min_key.s0;
  p->max_key = planes.max_key.s0;
  p->in_range = planes.in_range.s0 != 0;
}

// There is no room to keep it.
static inline void keep_margin(LargeTriangle* t, long margin) {}
static inline int margin_in_tile(global const LargeTriangle* t) {
  if (SAMPLES > 1) return 0;
  const int x[3] = {t->x[0], t->x[1], t->x[2]}, y[3] = {t->y[0], t->y[1], t->y[2]};
  const SnappedEdges d = snapped_edges(x, y);
  const int dx[3] = {d.d1x, d.d2x - d.d1x, d.d2x}, dy[3] = {d.d1y, d.d2y - d.d1y, d.d2y};
  return in_pixel_steps(margin_of_large(dx, dy));
}

// Doubled areas opposite to b and c at the first pixel of a tile; and of the whole.
typedef struct {
  long part_b, part_c, area;
  SnappedEdges edges;
} TileDepth;
static inline TileDepth depth_of_tile(global const LargeTriangle* t, int tile_x, int tile_y) {
  const int x[3] = {t->x[0], t->x[1], t->x[2]}, y[3] = {t->y[0], t->y[1], t->y[2]};
  const long dx = tile_x * SUBPIXELS + HALF_PIXEL - SUBPIXEL_OF(x[0]),
             dy = tile_y * SUBPIXELS + HALF_PIXEL - SUBPIXEL_OF(y[0]);
  const SnappedEdges d = snapped_edges(x, y);
  TileDepth origin;
  origin.edges = d;
  origin.part_b = dx * d.d2y - dy * d.d2x;
  origin.part_c = dy * d.d1x - dx * d.d1y;
  origin.area = (long)d.d1x * d.d2y - (long)d.d2x * d.d1y;
  return origin;
}

static inline TwoFloats normalized_depth_in_row(global const LargeTriangle* t, TileDepth origin, int column, int row) {
  const long16 columns = convert_long16(LANE + column) * SUBPIXELS;
  const long down = (long)row * SUBPIXELS;
  const SnappedEdges d = origin.edges;
  const long16 part_b = columns * d.d2y + (origin.part_b - down * d.d2x);
  const long16 part_c = (origin.part_c + down * d.d1x) - columns * d.d1y;
  const TwoFloats a = two_floats((float16)(t->plane.a[0]), (float16)(t->plane.a[1]));
  const TwoFloats b = two_floats((float16)(t->plane.b[0]), (float16)(t->plane.b[1]));
  const TwoFloats c = two_floats((float16)(t->plane.c[0]), (float16)(t->plane.c[1]));
  return interpolated(a, b, c, from_longs(origin.area - part_b - part_c), from_longs(part_b), from_longs(part_c));
}

ALWAYS_INLINE Depths within_corners(global const LargeTriangle* t, TwoFloats normalized_depth) {
  return min(max(key_of(normalized_depth), (uint16)(t->plane.min_key)), (uint16)(t->plane.max_key));
}
static inline Depths depths_in_row(global const LargeTriangle* t, TileDepth origin, int column, int row) {
  return within_corners(t, normalized_depth_in_row(t, origin, column, row));
}

// Normalized depth, from the corners' values over the doubled area, moved by what it changes to mirror images.
ALWAYS_INLINE TwoFloats moved(TwoFloats normalized_depth, float16 change, int16 outside) {
  const TwoFloats sum = sum_of(normalized_depth, two_floats(change, (float16)(0.0f)));
  normalized_depth.high = select(normalized_depth.high, sum.high, outside);
  normalized_depth.low = select(normalized_depth.low, sum.low, outside);
  return normalized_depth;
}

#if SAMPLES == 1
// The same where some may be outside the corners. The tile's first pixel is (tile_x, tile_y).
static inline Depths depths_beside_edges(global const LargeTriangle* t, TileDepth origin, int tile_x, int tile_y,
                                         int column, int row) {
  const int16 x[3] = {t->x[0], t->x[1], t->x[2]}, y[3] = {t->y[0], t->y[1], t->y[2]};
  const int16 px = ((LANE + (tile_x + column)) * SUBPIXELS + HALF_PIXEL) * CORNER_UNITS,
              py = ((tile_y + row) * SUBPIXELS + HALF_PIXEL) * CORNER_UNITS;
  const SnappedEdges d = origin.edges;
  const float depth1 = t->plane.b[0] - t->plane.a[0], depth2 = t->plane.c[0] - t->plane.a[0];
  const float dx = difference_of_two_products((float)d.d2y, depth1, (float)d.d1y, depth2),
              dy = difference_of_two_products((float)d.d1x, depth2, (float)d.d2x, depth1);
  int16 outside;
  const float16 change = to_mirror_image(x, y, px, py, (float16)(dx), (float16)(dy), &outside);
  return within_corners(t, moved(normalized_depth_in_row(t, origin, column, row), change, outside));
}
#endif
static inline int16 in_range(global const LargeTriangle* t, TileDepth origin, int column, int row) {
  if (t->plane.in_range) return (int16)(-1);
  return normalized_depth_in_row(t, origin, column, row).high >= 0.0f;
}
static inline bool is_in_range(global const LargeTriangle* t) { return t->plane.in_range != 0; }

typedef int BlockColumns;  // the first
ALWAYS_INLINE BlockColumns block_columns(TileDepth origin, int column) { return column; }
static inline Depths depths_in_covered_row(global const LargeTriangle* t, TileDepth origin, BlockColumns columns,
                                           int row) {
  return depths_in_row(t, origin, columns, row);
}

// Those of the whole triangle hold in every part of it.
typedef struct {
  Depths min, max;
} DepthBounds;
static inline DepthBounds depth_bounds(global const LargeTriangle* t, TileDepth origin, int16 left, int16 right,
                                       int16 top, int16 bottom) {
  DepthBounds bounds;
  bounds.min = t->plane.min_key;
  bounds.max = t->plane.max_key;
  return bounds;
}
static inline int16 bounds_are_within_corners(global const LargeTriangle* t, DepthBounds bounds) { return (int16)(-1); }

// ---- small triangles, one a lane ------------------------------------------------------------------------------------

typedef struct {
  NormalizedDepthPlanes normalized_depth;
  int16 area, part1, part2;                      // at the first pixel
  int16 part1_dx, part1_dy, part2_dx, part2_dy;  // per pixel
} SmallPlanes;

ALWAYS_INLINE SmallPlanes small_planes(Triangles t, int16 area, int16 px, int16 py,
                                       global const FrameConstants* frame) {
  const int16 d1x = t.x[1] - t.x[0], d1y = t.y[1] - t.y[0], d2x = t.x[2] - t.x[0], d2y = t.y[2] - t.y[0];
  const int16 dx = px - t.x[0], dy = py - t.y[0];
  SmallPlanes planes;
  // Lanes that are not drawn may have no area; they are not looked at.
  planes.normalized_depth = normalized_depth_planes(&t, from_ints(area), frame);
  planes.area = area;
  planes.part1 = dx * d2y - dy * d2x;
  planes.part2 = dy * d1x - dx * d1y;
  planes.part1_dx = d2y * SUBPIXELS;
  planes.part1_dy = -d2x * SUBPIXELS;
  planes.part2_dx = -d1y * SUBPIXELS;
  planes.part2_dy = d1x * SUBPIXELS;
  return planes;
}

typedef struct {
  int16 part1, part2;
} SmallRow;
ALWAYS_INLINE SmallRow small_row(const SmallPlanes* planes, int row) {
  SmallRow parts;
  parts.part1 = planes->part1 + planes->part1_dy * row;
  parts.part2 = planes->part2 + planes->part2_dy * row;
  return parts;
}

ALWAYS_INLINE TwoFloats small_normalized_depth(const SmallPlanes* planes, SmallRow row, int column) {
  const int16 part1 = row.part1 + planes->part1_dx * column, part2 = row.part2 + planes->part2_dx * column;
  const NormalizedDepthPlanes* p = &planes->normalized_depth;
  return interpolated(p->a, p->b, p->c, from_ints(planes->area - part1 - part2), from_ints(part1), from_ints(part2));
}

ALWAYS_INLINE Depths small_depths(const SmallPlanes* planes, SmallRow row, int column, int16* covered) {
  const TwoFloats normalized_depth = small_normalized_depth(planes, row, column);
  const NormalizedDepthPlanes* p = &planes->normalized_depth;
  *covered &= p->in_range | (normalized_depth.high >= 0.0f);
  return min(max(key_of(normalized_depth), p->min_key), p->max_key);
}

#if SAMPLES == 1
// The same where some may be outside the corners; (px, py): the pixels' centres, sub-pixels.
static RARELY_CALLED Depths small_depths_beside_edges(const Triangles* t, const SmallPlanes* planes, SmallRow row,
                                                      int column, int16 px, int16 py, int16* covered) {
  const TwoFloats normalized_depth = small_normalized_depth(planes, row, column);
  const NormalizedDepthPlanes* p = &planes->normalized_depth;
  *covered &= p->in_range | (normalized_depth.high >= 0.0f);
  const float16 depth1 = p->b.high - p->a.high, depth2 = p->c.high - p->a.high;
  const float16 d1x = convert_float16(t->x[1] - t->x[0]), d1y = convert_float16(t->y[1] - t->y[0]),
                d2x = convert_float16(t->x[2] - t->x[0]), d2y = convert_float16(t->y[2] - t->y[0]);
  int16 outside;
  const float16 change = to_mirror_image(t->corner_x, t->corner_y, px * CORNER_UNITS, py * CORNER_UNITS,
                                         difference_of_products(d2y, depth1, d1y, depth2),
                                         difference_of_products(d1x, depth2, d2x, depth1), &outside);
  return min(max(key_of(moved(normalized_depth, change, outside)), p->min_key), p->max_key);
}
#endif

// ---- lines ----------------------------------------------------------------------------------------------------------

typedef struct {
  TwoFloats start, end;  // at the sub-pixels that the ends are snapped to
  uint min_key, max_key;
} LineDepth;
static inline LineDepth line_depth(int4 a, int4 b, bool steep, global const FrameConstants* frame) {
  const AlongLine along = along_line(a, b, steep);
  const TwoFloats at_a = normalized_depth_of((float16)(as_float(a.z)), frame),
                  at_b = normalized_depth_of((float16)(as_float(b.z)), frame);
  const float16 slope =
      along.length > 0.0f ? rounded_difference(at_b, at_a) / (float16)(along.length) : (float16)(0.0f);
  const uint key_a = key_of(at_a).s0, key_b = key_of(at_b).s0;
  LineDepth line;
  line.start = sum_of(at_a, two_floats(slope * along.to_start, (float16)(0.0f)));
  line.end = sum_of(at_b, two_floats(slope * along.to_end, (float16)(0.0f)));
  line.min_key = min(key_a, key_b);
  line.max_key = max(key_a, key_b);
  return line;
}
static inline bool depth_on_line(const LineDepth* line, long offset, long run, uint* bits) {
  const TwoFloats whole = from_longs((long16)(run));
  const TwoFloats at_start = product_of(line->start, from_longs((long16)(run - offset)));
  const TwoFloats normalized_depth =
      quotient_of(sum_of(at_start, product_of(line->end, from_longs((long16)(offset)))), whole);
  *bits = min(max(key_of(normalized_depth).s0, line->min_key), line->max_key);
  return normalized_depth.high.s0 >= 0.0f;
}

// ---- vertices -------------------------------------------------------------------------------------------------------

// What a vertex record keeps for depth: the distance.
ALWAYS_INLINE float16 vertex_depth(float16 clip_z, float16 clip_w, float16 inverse_w,
                                   global const FrameConstants* frame) {
  return frame->camera.parallel ? -clip_z : clip_w;
}

#endif
