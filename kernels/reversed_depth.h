// The default depth buffer: near / distance, in parallel projections minus the distance, as float.
//
// Depth is affine on the screen. It grows from a triangle's farthest corner, without cancellation, and is stepped from
// the first pixel of a tile (large triangles) or of the triangle's box (small ones). Rounding is monotone, so the
// extremes in a rectangle of pixels lie at its corners. All functions are those of forward_depth.h as well.

#ifndef MORPHCL_REVERSED_DEPTH_H
#define MORPHCL_REVERSED_DEPTH_H

#include "layout.h"
#include "raster.h"
#include "vector.h"

typedef float Depth;  // larger is nearer
typedef float16 Depths;
#define FARTHEST_DEPTH (-INFINITY)
#define NEAREST_DEPTH INFINITY

static inline Depth min_depth(Depths depths) { return reduce_min(depths); }
static inline Depth max_depth(Depths depths) { return reduce_max(depths); }
static inline Depth depth_from_bits(uint bits) { return as_float(bits); }
static inline Depth background_depth(global const FrameConstants* frame) { return frame->camera.far_depth; }
// What eye_distance() takes.
ALWAYS_INLINE float16 decoded_depth(Depths depth, global const FrameConstants* frame) { return depth; }

// ---- large triangles ------------------------------------------------------------------------------------------------

// Corner a becomes the one of least depth; the turn keeps the orientation.
static inline void turn_for_depth(int4* a, int4* b, int4* c) {
  const float depth_a = as_float((*a).z), depth_b = as_float((*b).z), depth_c = as_float((*c).z);
  const int4 first = *a, second = *b, third = *c;
  if (depth_b < depth_a && depth_b <= depth_c) {
    *a = second;
    *b = third;
    *c = first;
  } else if (depth_c < depth_a && depth_c < depth_b) {
    *a = third;
    *b = first;
    *c = second;
  }
}

static inline void set_depth_plane(LargeTriangle* t, int4 a, int4 b, int4 c, long area,
                                   global const FrameConstants* frame) {
  DepthPlane* p = &t->plane;
  p->depth = as_float(a.z);
  p->depth1 = as_float(b.z) - p->depth;
  p->depth2 = as_float(c.z) - p->depth;
  p->inverse_area = 1.0f / (float)area;
  p->depth_dx = fma((float)t->d2y, p->depth1, -((float)t->d1y * p->depth2)) * p->inverse_area * (float)SUBPIXELS;
  p->depth_dy = fma((float)t->d1x, p->depth2, -((float)t->d2x * p->depth1)) * p->inverse_area * (float)SUBPIXELS;
  FOR_THREE(i) p->pad[i] = 0;
}

// Depth at the first pixel of a tile, from the exact doubled areas of the parts: depth + depth1 * s1 / area + depth2 *
// s2 / area.
typedef float TileDepth;
static inline TileDepth depth_of_tile(global const LargeTriangle* t, int tile_x, int tile_y) {
  const long dx = tile_x * SUBPIXELS + HALF_PIXEL - t->ax, dy = tile_y * SUBPIXELS + HALF_PIXEL - t->ay;
  const float part1 = (float)(dx * t->d2y - dy * t->d2x) * t->plane.inverse_area;
  const float part2 = (float)(dy * t->d1x - dx * t->d1y) * t->plane.inverse_area;
  return fma(part1, t->plane.depth1, fma(part2, t->plane.depth2, t->plane.depth));
}

// Sixteen pixels of a row of the tile, from a column on.
static inline Depths depths_in_row(global const LargeTriangle* t, TileDepth corner, int column, int row) {
  return fma((float16)(t->plane.depth_dx), convert_float16(LANE + column),
             (float16)(fma(t->plane.depth_dy, (float)row, corner)));
}
// Of these, and of a whole triangle: what is not beyond the far plane. Here that is told by comparing with the
// background.
static inline int16 in_range(global const LargeTriangle* t, TileDepth corner, int column, int row) {
  return (int16)(-1);
}
static inline bool is_in_range(global const LargeTriangle* t) { return true; }

// The least and the greatest depth in rectangles of the tile.
typedef struct {
  Depths min, max;
} DepthBounds;
static inline DepthBounds depth_bounds(global const LargeTriangle* t, TileDepth corner, int16 left, int16 right,
                                       int16 top, int16 bottom) {
  const float depth_dx = t->plane.depth_dx, depth_dy = t->plane.depth_dy;
  const int16 falls_x = depth_dx < 0.0f ? (int16)(-1) : (int16)(0),
              falls_y = depth_dy < 0.0f ? (int16)(-1) : (int16)(0);
  const float16 farthest_x = convert_float16(select(left, right, falls_x)),
                nearest_x = convert_float16(select(right, left, falls_x));
  const float16 farthest_y = convert_float16(select(top, bottom, falls_y)),
                nearest_y = convert_float16(select(bottom, top, falls_y));
  DepthBounds bounds;
  bounds.min = fma((float16)(depth_dx), farthest_x, fma((float16)(depth_dy), farthest_y, (float16)(corner)));
  bounds.max = fma((float16)(depth_dx), nearest_x, fma((float16)(depth_dy), nearest_y, (float16)(corner)));
  return bounds;
}

// ---- small triangles, one a lane ------------------------------------------------------------------------------------

typedef struct {
  float16 origin, dx, dy;  // at the first pixel; per pixel
} SmallPlanes;

// `part1` and `part2`: the doubled areas opposite to the corners 1 and 2 at the first pixel.
ALWAYS_INLINE SmallPlanes small_planes(const int16 depth[3], int16 area, int16 part1, int16 part2, int16 d1x, int16 d1y,
                                       int16 d2x, int16 d2y, global const FrameConstants* frame) {
  const float16 depth0 = as_float16(depth[0]);
  const float16 depth1 = as_float16(depth[1]) - depth0, depth2 = as_float16(depth[2]) - depth0;
  const float16 inverse_area = 1.0f / convert_float16(area);
  SmallPlanes planes;
  planes.origin =
      fma(convert_float16(part1) * inverse_area, depth1, fma(convert_float16(part2) * inverse_area, depth2, depth0));
  planes.dx = fma(convert_float16(d2y), depth1, -(convert_float16(d1y) * depth2)) * inverse_area * (float)SUBPIXELS;
  planes.dy = fma(convert_float16(d1x), depth2, -(convert_float16(d2x) * depth1)) * inverse_area * (float)SUBPIXELS;
  return planes;
}

typedef float16 SmallRow;
ALWAYS_INLINE SmallRow small_row(const SmallPlanes* planes, int row) {
  return fma(planes->dy, (float16)((float)row), planes->origin);
}

// At a column of the row; takes out of `covered` what is beyond the far plane.
ALWAYS_INLINE Depths small_depths(const SmallPlanes* planes, SmallRow row, int column, int16* covered) {
  return fma(planes->dx, (float16)((float)column), row);
}

// ---- lines ----------------------------------------------------------------------------------------------------------

typedef struct {
  float start, change;
} LineDepth;
static inline LineDepth line_depth(int4 a, int4 b, global const FrameConstants* frame) {
  LineDepth line;
  line.start = as_float(a.z);
  line.change = as_float(b.z) - line.start;
  return line;
}
// The bits of the depth after offset / run of the line; false beyond the far plane.
static inline bool depth_on_line(const LineDepth* line, long offset, long run, uint* bits) {
  *bits = as_uint(fma((float)offset / (float)run, line->change, line->start));
  return true;
}

// ---- vertices -------------------------------------------------------------------------------------------------------

// What a vertex record keeps for depth.
ALWAYS_INLINE float16 vertex_depth(float16 clip_z, float16 clip_w, float16 inverse_w,
                                   global const FrameConstants* frame) {
  return clip_z * inverse_w;
}

#endif
