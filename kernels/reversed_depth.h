// The default depth buffer: near / distance, in parallel projections minus the distance, as float.
//
// Depth is affine on the screen, on the plane through the corners where they are: coverage alone takes them from the
// grid of sub-pixels. It grows from a triangle's farthest corner, without cancellation, and is stepped from the pixel
// of a tile that is next to that corner (large triangles) or the first of the triangle's box (small ones). Where the
// grid covers what is outside the corners, depth stays within theirs. Rounding is monotone, so the extremes in a
// rectangle of pixels lie at its corners. All functions are those of forward_depth.h as well.

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

static inline void set_depth_plane(LargeTriangle* t, int4 a, int4 b, int4 c, global const FrameConstants* frame) {
  DepthPlane* p = &t->plane;
  const float d1x = (float)(t->x[1] - t->x[0]), d1y = (float)(t->y[1] - t->y[0]);
  const float d2x = (float)(t->x[2] - t->x[0]), d2y = (float)(t->y[2] - t->y[0]);
  p->depth = as_float(a.z);
  p->nearest = max(as_float(b.z), max(as_float(c.z), p->depth));
  const float depth1 = (as_float(b.z) - p->depth) * SUBPIXELS_OF_CORNER_UNIT,
              depth2 = (as_float(c.z) - p->depth) * SUBPIXELS_OF_CORNER_UNIT;
  const float area = difference_of_two_products(d1x, d2y, d2x, d1y);
  // Change of depth a corner unit, of the differences above; a pixel has CORNER_UNITS SUBPIXELS of them.
  const float scale = area == 0.0f ? 0.0f : (float)(CORNER_UNITS) / area;
  const float unit_dx = difference_of_two_products(d2y, depth1, d1y, depth2) * scale,
              unit_dy = difference_of_two_products(d1x, depth2, d2x, depth1) * scale;
  p->depth_dx = unit_dx * (float)(CORNER_UNITS * SUBPIXELS);
  p->depth_dy = unit_dy * (float)(CORNER_UNITS * SUBPIXELS);
  for (int i = 0; i < 4; i++) p->pad[i] = 0;
}

// What margin_in_tile() is to be.
static inline void keep_margin(LargeTriangle* t, long margin) { t->plane.margin = in_pixel_steps(margin); }
static inline int margin_in_tile(global const LargeTriangle* t) { return t->plane.margin; }

// Depth at the tile's pixel that is next to the farthest corner.
typedef struct {
  float depth;
  int column, row;
} TileDepth;
static inline TileDepth depth_of_tile(global const LargeTriangle* t, int tile_x, int tile_y) {
  TileDepth origin;
  origin.column = clamp((SUBPIXEL_OF(t->x[0]) >> SUBPIXEL_BITS) - tile_x, 0, TILE - 1);
  origin.row = clamp((SUBPIXEL_OF(t->y[0]) >> SUBPIXEL_BITS) - tile_y, 0, TILE - 1);
  const int px = (tile_x + origin.column) * SUBPIXELS + HALF_PIXEL, py = (tile_y + origin.row) * SUBPIXELS + HALF_PIXEL;
  const float pixel = 1.0f / (CORNER_UNITS * SUBPIXELS);
  origin.depth = fma(t->plane.depth_dx * pixel, (float)(px * CORNER_UNITS - t->x[0]),
                     fma(t->plane.depth_dy * pixel, (float)(py * CORNER_UNITS - t->y[0]), t->plane.depth));
  return origin;
}

// What the plane has, within the depths of the corners.
ALWAYS_INLINE Depths within_corners(global const LargeTriangle* t, Depths depth) {
  const Depths farthest = t->plane.depth, nearest = t->plane.nearest;
  return min(max(depth, farthest), nearest);
}

// Sixteen pixels of a row of the tile, from a column on.
ALWAYS_INLINE Depths depths_on_plane(global const LargeTriangle* t, TileDepth origin, int column, int row) {
  return fma((float16)(t->plane.depth_dx), convert_float16(LANE + (column - origin.column)),
             (float16)(fma(t->plane.depth_dy, (float)(row - origin.row), origin.depth)));
}
static inline Depths depths_in_row(global const LargeTriangle* t, TileDepth origin, int column, int row) {
  return within_corners(t, depths_on_plane(t, origin, column, row));
}
// Of a block that needs no look at the corners, since bounds_are_within_corners(): its columns, from the origin.
typedef float16 BlockColumns;
ALWAYS_INLINE BlockColumns block_columns(TileDepth origin, int column) {
  return convert_float16(LANE + (column - origin.column));
}
ALWAYS_INLINE Depths depths_in_covered_row(global const LargeTriangle* t, TileDepth origin, BlockColumns columns,
                                           int row) {
  return fma((float16)(t->plane.depth_dx), columns,
             (float16)(fma(t->plane.depth_dy, (float)(row - origin.row), origin.depth)));
}
#if SAMPLES == 1
// The same where some may be outside the corners. The tile's first pixel is (tile_x, tile_y).
static inline Depths depths_beside_edges(global const LargeTriangle* t, TileDepth origin, int tile_x, int tile_y,
                                         int column, int row) {
  const int16 x[3] = {t->x[0], t->x[1], t->x[2]}, y[3] = {t->y[0], t->y[1], t->y[2]};
  const int16 px = ((LANE + (tile_x + column)) * SUBPIXELS + HALF_PIXEL) * CORNER_UNITS,
              py = ((tile_y + row) * SUBPIXELS + HALF_PIXEL) * CORNER_UNITS;
  int16 outside;
  const float16 change = to_mirror_image(x, y, px, py, (float16)(t->plane.depth_dx * (1.0f / SUBPIXELS)),
                                         (float16)(t->plane.depth_dy * (1.0f / SUBPIXELS)), &outside);
  const Depths depth = depths_on_plane(t, origin, column, row);
  return within_corners(t, select(depth, depth + change, outside));
}
#endif
// Of these, and of a whole triangle: what is not beyond the far plane. Here that is told by comparing with the
// background.
static inline int16 in_range(global const LargeTriangle* t, TileDepth origin, int column, int row) {
  return (int16)(-1);
}
static inline bool is_in_range(global const LargeTriangle* t) { return true; }

// The least and the greatest depth in rectangles of the tile.
typedef struct {
  Depths min, max;
} DepthBounds;
static inline DepthBounds depth_bounds(global const LargeTriangle* t, TileDepth origin, int16 left, int16 right,
                                       int16 top, int16 bottom) {
  const float depth_dx = t->plane.depth_dx, depth_dy = t->plane.depth_dy;
  const int16 falls_x = depth_dx < 0.0f ? (int16)(-1) : (int16)(0),
              falls_y = depth_dy < 0.0f ? (int16)(-1) : (int16)(0);
  const float16 farthest_x = convert_float16(select(left, right, falls_x) - origin.column),
                nearest_x = convert_float16(select(right, left, falls_x) - origin.column);
  const float16 farthest_y = convert_float16(select(top, bottom, falls_y) - origin.row),
                nearest_y = convert_float16(select(bottom, top, falls_y) - origin.row);
  const float16 dx = depth_dx, dy = depth_dy, start = origin.depth;
  DepthBounds bounds;
  bounds.min = fma(dx, farthest_x, fma(dy, farthest_y, start));
  bounds.max = fma(dx, nearest_x, fma(dy, nearest_y, start));
  return bounds;
}
static inline int16 bounds_are_within_corners(global const LargeTriangle* t, DepthBounds bounds) {
  return (bounds.min >= t->plane.depth) & (bounds.max <= t->plane.nearest);
}

// ---- small triangles, one a lane ------------------------------------------------------------------------------------

typedef struct {
  float16 origin, dx, dy;  // at the first pixel; per pixel
#if SAMPLES == 1
  float16 farthest, nearest;  // of the corners
#endif
} SmallPlanes;

// (px, py): the centre of the first pixel, sub-pixels. `area`: the doubled one of the sub-pixels.
ALWAYS_INLINE SmallPlanes small_planes(Triangles t, int16 area, int16 px, int16 py,
                                       global const FrameConstants* frame) {
  const float16 d1x = convert_float16(t.corner_x[1] - t.corner_x[0]),
                d1y = convert_float16(t.corner_y[1] - t.corner_y[0]),
                d2x = convert_float16(t.corner_x[2] - t.corner_x[0]),
                d2y = convert_float16(t.corner_y[2] - t.corner_y[0]);
  const float16 depth0 = as_float16(t.depth[0]), depth1 = (as_float16(t.depth[1]) - depth0) * SUBPIXELS_OF_CORNER_UNIT,
                depth2 = (as_float16(t.depth[2]) - depth0) * SUBPIXELS_OF_CORNER_UNIT;
  const float16 true_area = difference_of_products(d1x, d2y, d2x, d1y);
  // Change of depth a corner unit, of the differences above; a pixel has CORNER_UNITS SUBPIXELS of them.
  const float16 scale = select((float)(CORNER_UNITS) / true_area, (float16)(0.0f), true_area == 0.0f);
  const float16 unit_dx = difference_of_products(d2y, depth1, d1y, depth2) * scale,
                unit_dy = difference_of_products(d1x, depth2, d2x, depth1) * scale;
  SmallPlanes planes;
  planes.origin = fma(unit_dx, convert_float16(px * CORNER_UNITS - t.corner_x[0]),
                      fma(unit_dy, convert_float16(py * CORNER_UNITS - t.corner_y[0]), depth0));
  planes.dx = unit_dx * (float)(CORNER_UNITS * SUBPIXELS);
  planes.dy = unit_dy * (float)(CORNER_UNITS * SUBPIXELS);
#if SAMPLES == 1
  planes.farthest = min(depth0, min(as_float16(t.depth[1]), as_float16(t.depth[2])));
  planes.nearest = max(depth0, max(as_float16(t.depth[1]), as_float16(t.depth[2])));
#endif
  return planes;
}

typedef float16 SmallRow;
ALWAYS_INLINE SmallRow small_row(const SmallPlanes* planes, int row) {
  return fma(planes->dy, (float16)((float)row), planes->origin);
}

// At a column of the row; takes out of `covered` what is beyond the far plane.
ALWAYS_INLINE Depths small_depths(const SmallPlanes* planes, SmallRow row, int column, int16* covered) {
  const Depths depth = fma(planes->dx, (float16)((float)column), row);
#if SAMPLES == 1
  return min(max(depth, planes->farthest), planes->nearest);
#else
  return depth;  // from which samples go on: the centre itself may be outside
#endif
}
#if SAMPLES == 1
// The same where some may be outside the corners; (px, py): the pixels' centres, sub-pixels.
static RARELY_CALLED Depths small_depths_beside_edges(const Triangles* t, const SmallPlanes* planes, SmallRow row,
                                                      int column, int16 px, int16 py, int16* covered) {
  int16 outside;
  const float16 change = to_mirror_image(t->corner_x, t->corner_y, px * CORNER_UNITS, py * CORNER_UNITS,
                                         planes->dx * (1.0f / SUBPIXELS), planes->dy * (1.0f / SUBPIXELS), &outside);
  const Depths depth = fma(planes->dx, (float16)((float)column), row);
  return min(max(select(depth, depth + change, outside), planes->farthest), planes->nearest);
}
#endif

// ---- lines ----------------------------------------------------------------------------------------------------------

// Measured along the longer axis between the ends where they are, from the sub-pixel that the start is snapped to.
typedef struct {
  float start, change;  // there, and from there to the snapped end
  float farthest, nearest;
} LineDepth;
static inline LineDepth line_depth(int4 a, int4 b, bool steep, global const FrameConstants* frame) {
  const AlongLine along = along_line(a, b, steep);
  const float depth_a = as_float(a.z), depth_b = as_float(b.z);
  const float slope = along.length > 0.0f ? (depth_b - depth_a) / along.length : 0.0f;
  LineDepth line;
  line.start = fma(slope, along.to_start, depth_a);
  line.change = slope * along.run;
  line.farthest = min(depth_a, depth_b);
  line.nearest = max(depth_a, depth_b);
  return line;
}
// The bits of the depth after offset / run of the line; false beyond the far plane.
static inline bool depth_on_line(const LineDepth* line, long offset, long run, uint* bits) {
  *bits = as_uint(min(max(fma((float)offset / (float)run, line->change, line->start), line->farthest), line->nearest));
  return true;
}

// ---- vertices -------------------------------------------------------------------------------------------------------

// What a vertex record keeps for depth.
ALWAYS_INLINE float16 vertex_depth(float16 clip_z, float16 clip_w, float16 inverse_w,
                                   global const FrameConstants* frame) {
  return clip_z * inverse_w;
}

#endif
