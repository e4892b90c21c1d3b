// The arithmetic of one vertex, shared by projection (16 lanes) and clipping (one lane would do; it uses 16 as well, so
// that there is one definition): morph, object to clip space, outcode, place on the screen.

#ifndef MORPHCL_VERTEX_H
#define MORPHCL_VERTEX_H

#include "layout.h"
#include "vector.h"

typedef struct {
  float16 x, y, z, w;
} ClipPoints;

typedef struct {
  int16 x, y;  // corner units
  float16 depth, inverse_w;
} ScreenPoints;

// Three planes of one morphed attribute of 16 vertices: base, then each active target that has the attribute.
//   p <- fma(weight, target, fma(base_weight, base, p))
#define MORPH_3(mesh_data, base_offset, pitch, at, targets, first, count, ATTRIBUTE, x, y, z)         \
  {                                                                                                   \
    const float16 base_x = vload16(0, mesh_data + base_offset + at);                                  \
    const float16 base_y = vload16(0, mesh_data + base_offset + pitch + at);                          \
    const float16 base_z = vload16(0, mesh_data + base_offset + 2 * pitch + at);                      \
    x = base_x;                                                                                       \
    y = base_y;                                                                                       \
    z = base_z;                                                                                       \
    for (uint k = 0; k < count; k++) {                                                                \
      const uint plane = targets[first + k].ATTRIBUTE;                                                \
      if (plane == NO_ID) continue;                                                                   \
      const float16 weight = targets[first + k].weight, base_weight = targets[first + k].base_weight; \
      x = fma(weight, vload16(0, mesh_data + plane + at), fma(base_weight, base_x, x));               \
      y = fma(weight, vload16(0, mesh_data + plane + pitch + at), fma(base_weight, base_y, y));       \
      z = fma(weight, vload16(0, mesh_data + plane + 2 * pitch + at), fma(base_weight, base_z, z));   \
    }                                                                                                 \
  }

static inline ClipPoints to_clip(global const DrawConstants* draw, float16 x, float16 y, float16 z) {
  ClipPoints p;
  p.x = row_times_point(draw->object_to_clip[0], x, y, z);
  p.y = row_times_point(draw->object_to_clip[1], x, y, z);
  p.z = row_times_point(draw->object_to_clip[2], x, y, z);
  p.w = row_times_point(draw->object_to_clip[3], x, y, z);
  return p;
}

// Positive in front of the near plane: w - near in perspective, near_depth - z in parallel projections.
static inline float16 near_distance(float16 z, float16 w, global const FrameConstants* frame) {
  return fma((float16)(frame->camera.near_plane[0]), z,
             fma((float16)(frame->camera.near_plane[1]), w, (float16)(frame->camera.near_plane[2])));
}

// Every test is positive, so a NaN fails all of them and counts as invalid.
static inline int16 outcode(ClipPoints p, global const FrameConstants* frame) {
  const float16 limit_x = p.w * frame->guard_x, limit_y = p.w * frame->guard_y;
  const int16 finite = (fabs(p.x) <= MAX_CLIP_COORDINATE) & (fabs(p.y) <= MAX_CLIP_COORDINATE) &
                       (fabs(p.z) <= MAX_CLIP_COORDINATE) & (fabs(p.w) <= MAX_CLIP_COORDINATE);
  int16 code = ~(near_distance(p.z, p.w, frame) >= 0.0f) & OUT_NEAR;
  code |= ~(p.x >= -limit_x) & OUT_LEFT;
  code |= ~(p.x <= limit_x) & OUT_RIGHT;
  code |= ~(p.y <= limit_y) & OUT_TOP;
  code |= ~(p.y >= -limit_y) & OUT_BOTTOM;
  return code | (~finite & OUT_INVALID);
}

// product + product_rest + offset in corner units: round() of it, ties to even, is the sub-pixel that the vertex is
// snapped to; what that took away is rounded to corner units, and to that side of the tie.
static inline int16 round_to_grid(float16 product, float16 product_rest, float16 offset) {
  const float16 sum = product + offset;
  const float16 offset_part = sum - product;
  const float16 sum_rest = (product - (sum - offset_part)) + (offset - offset_part);
  const float16 whole = rint(sum);
  const float16 rest = (sum - whole) + (sum_rest + product_rest);
  const float16 step = rint(rest);
  const float16 units = min(rint((rest - step) * (float)CORNER_UNITS), (float16)(CORNER_UNITS / 2 - 1));
  return convert_int16(whole + step) * CORNER_UNITS + convert_int16(units);
}

// v / w * scale + offset in corner units, as if the quotient, product and sum had about 45 bits: the quotient's
// remainder and the errors of product and sum are carried along (two-float arithmetic), so a vertex is snapped to
// another sub-pixel than the exact one only within 2^-24 of a tie. |result| < 2^30.
static inline int16 snap(float16 v, float16 w, float scale, float offset) {
  const float16 scales = scale;
  const float16 quotient = v / w;
  const float16 quotient_rest = fma(-quotient, w, v) / w;
  const float16 product = quotient * scales;
  return round_to_grid(product, fma(quotient_rest, scales, fma(quotient, scales, -product)), (float16)offset);
}

// The same for w = 1.
static inline int16 snap_undivided(float16 v, float scale, float offset) {
  const float16 scales = scale;
  const float16 product = v * scales;
  return round_to_grid(product, fma(v, scales, -product), (float16)offset);
}

#endif
