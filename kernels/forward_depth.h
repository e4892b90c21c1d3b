// Depth buffers that span near to far: float, and fixed point of 16, 24 and 32 bits. The functions are those of
// reversed_depth.h, which is the faster one.
//
// A vertex record keeps the distance along the view axis. Normalized depth is 1 on the near plane and 0 on the far one:
//   (q - depth_far) * depth_scale,  q = near / distance and depth_far = near / far; parallel: minus the distances
// It is affine on the screen, and interpolated in two floats by the exact doubled areas opposite to the corners, each
// times its corner's normalized depth over the whole area: no cancellation, about 2^-40 of the largest. What is stored
// is a *key*:
//   fixed   normalized depth times the number of steps, rounded to nearest
//   float   the bits of 1 less those of 1 - normalized depth, rounded to float: neighbouring floats have neighbouring
//           keys
// Keys lie between those of the corners. What is beyond the far plane, of negative normalized depth, is not drawn.

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

static inline NormalizedDepthPlanes normalized_depth_planes(float16 distance_a, float16 distance_b, float16 distance_c,
                                                            TwoFloats area, global const FrameConstants* frame) {
  const TwoFloats a = normalized_depth_of(distance_a, frame), b = normalized_depth_of(distance_b, frame),
                  c = normalized_depth_of(distance_c, frame);
  const uint16 key_a = key_of(a), key_b = key_of(b), key_c = key_of(c);
  NormalizedDepthPlanes planes;
  planes.min_key = min(key_a, min(key_b, key_c));
  planes.max_key = max(key_a, max(key_b, key_c));
  planes.in_range = (a.high >= 0.0f) & (b.high >= 0.0f) & (c.high >= 0.0f);
  planes.a = quotient_of(a, area);
  planes.b = quotient_of(b, area);
  planes.c = quotient_of(c, area);
  return planes;
}

static inline TwoFloats interpolated(TwoFloats a, TwoFloats b, TwoFloats c, TwoFloats part_a, TwoFloats part_b,
                                     TwoFloats part_c) {
  return sum_of(product_of(part_a, a), sum_of(product_of(part_b, b), product_of(part_c, c)));
}

// ---- large triangles ------------------------------------------------------------------------------------------------

static inline void turn_for_depth(int4* a, int4* b, int4* c) {}

static inline void set_depth_plane(LargeTriangle* t, int4 a, int4 b, int4 c, long area,
                                   global const FrameConstants* frame) {
  const NormalizedDepthPlanes planes = normalized_depth_planes(
      (float16)(as_float(a.z)), (float16)(as_float(b.z)), (float16)(as_float(c.z)), from_longs((long16)(area)), frame);
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

// Doubled areas opposite to b and c at the first pixel of a tile; and of the whole.
typedef struct {
  long part_b, part_c, area;
} TileDepth;
static inline TileDepth depth_of_tile(global const LargeTriangle* t, int tile_x, int tile_y) {
  const long dx = tile_x * SUBPIXELS + HALF_PIXEL - t->ax, dy = tile_y * SUBPIXELS + HALF_PIXEL - t->ay;
  TileDepth corner;
  corner.part_b = dx * t->d2y - dy * t->d2x;
  corner.part_c = dy * t->d1x - dx * t->d1y;
  corner.area = (long)t->d1x * t->d2y - (long)t->d2x * t->d1y;
  return corner;
}

static inline TwoFloats normalized_depth_in_row(global const LargeTriangle* t, TileDepth corner, int column, int row) {
  const long16 columns = convert_long16(LANE + column) * SUBPIXELS;
  const long down = (long)row * SUBPIXELS;
  const long16 part_b = columns * t->d2y + (corner.part_b - down * t->d2x);
  const long16 part_c = (corner.part_c + down * t->d1x) - columns * t->d1y;
  const TwoFloats a = two_floats((float16)(t->plane.a[0]), (float16)(t->plane.a[1]));
  const TwoFloats b = two_floats((float16)(t->plane.b[0]), (float16)(t->plane.b[1]));
  const TwoFloats c = two_floats((float16)(t->plane.c[0]), (float16)(t->plane.c[1]));
  return interpolated(a, b, c, from_longs(corner.area - part_b - part_c), from_longs(part_b), from_longs(part_c));
}

static inline Depths depths_in_row(global const LargeTriangle* t, TileDepth corner, int column, int row) {
  return min(max(key_of(normalized_depth_in_row(t, corner, column, row)), (uint16)(t->plane.min_key)),
             (uint16)(t->plane.max_key));
}
static inline int16 in_range(global const LargeTriangle* t, TileDepth corner, int column, int row) {
  if (t->plane.in_range) return (int16)(-1);
  return normalized_depth_in_row(t, corner, column, row).high >= 0.0f;
}
static inline bool is_in_range(global const LargeTriangle* t) { return t->plane.in_range != 0; }

// Those of the whole triangle hold in every part of it.
typedef struct {
  Depths min, max;
} DepthBounds;
static inline DepthBounds depth_bounds(global const LargeTriangle* t, TileDepth corner, int16 left, int16 right,
                                       int16 top, int16 bottom) {
  DepthBounds bounds;
  bounds.min = t->plane.min_key;
  bounds.max = t->plane.max_key;
  return bounds;
}

// ---- small triangles, one a lane ------------------------------------------------------------------------------------

typedef struct {
  NormalizedDepthPlanes normalized_depth;
  int16 area, part1, part2;                      // at the first pixel
  int16 part1_dx, part1_dy, part2_dx, part2_dy;  // per pixel
} SmallPlanes;

ALWAYS_INLINE SmallPlanes small_planes(const int16 depth[3], int16 area, int16 part1, int16 part2, int16 d1x, int16 d1y,
                                       int16 d2x, int16 d2y, global const FrameConstants* frame) {
  SmallPlanes planes;
  // Lanes that are not drawn may have no area; they are not looked at.
  planes.normalized_depth =
      normalized_depth_planes(as_float16(depth[0]), as_float16(depth[1]), as_float16(depth[2]), from_ints(area), frame);
  planes.area = area;
  planes.part1 = part1;
  planes.part2 = part2;
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

ALWAYS_INLINE Depths small_depths(const SmallPlanes* planes, SmallRow row, int column, int16* covered) {
  const int16 part1 = row.part1 + planes->part1_dx * column, part2 = row.part2 + planes->part2_dx * column;
  const NormalizedDepthPlanes* p = &planes->normalized_depth;
  const TwoFloats normalized_depth =
      interpolated(p->a, p->b, p->c, from_ints(planes->area - part1 - part2), from_ints(part1), from_ints(part2));
  *covered &= p->in_range | (normalized_depth.high >= 0.0f);
  return min(max(key_of(normalized_depth), p->min_key), p->max_key);
}

// ---- lines ----------------------------------------------------------------------------------------------------------

typedef struct {
  TwoFloats start, end;
} LineDepth;
static inline LineDepth line_depth(int4 a, int4 b, global const FrameConstants* frame) {
  LineDepth line;
  line.start = normalized_depth_of((float16)(as_float(a.z)), frame);
  line.end = normalized_depth_of((float16)(as_float(b.z)), frame);
  return line;
}
static inline bool depth_on_line(const LineDepth* line, long offset, long run, uint* bits) {
  const TwoFloats whole = from_longs((long16)(run));
  const TwoFloats at_start = product_of(line->start, from_longs((long16)(run - offset)));
  const TwoFloats normalized_depth =
      quotient_of(sum_of(at_start, product_of(line->end, from_longs((long16)(offset)))), whole);
  *bits = key_of(normalized_depth).s0;
  return normalized_depth.high.s0 >= 0.0f;
}

// ---- vertices -------------------------------------------------------------------------------------------------------

// What a vertex record keeps for depth: the distance.
ALWAYS_INLINE float16 vertex_depth(float16 clip_z, float16 clip_w, float16 inverse_w,
                                   global const FrameConstants* frame) {
  return frame->camera.parallel ? -clip_z : clip_w;
}

#endif
