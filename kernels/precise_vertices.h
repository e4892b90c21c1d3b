// Vertices of draws whose scene states an error that fp32 alone does not keep: relative to a pivot, or in two floats.
// As calls, so that they take no registers from the others.

#ifndef MORPHCL_PRECISE_VERTICES_H
#define MORPHCL_PRECISE_VERTICES_H

#include "layout.h"
#include "two_float.h"
#include "vector.h"
#include "vertex.h"

typedef struct {
  float16 position[3];  // what attributes are made of
  ClipPoints clip;
} PreciseVertices;

// Base and absolute targets are taken relative to the pivot; deltas are relative already.
COMPILED_ONCE PreciseVertices pivot_vertices(global const DrawConstants* draw, global const PreciseConstants* precise,
                                             global const TargetConstants* targets, global const float* mesh_data,
                                             uint at) {
  PreciseVertices vertices;
  FOR_THREE(c) {
    const float16 pivot = precise->pivot[c];
    const float16 base = vload16(0, mesh_data + draw->positions + c * draw->pitch + at) - pivot;
    float16 value = base;
    for (uint k = draw->first_target; k < draw->first_target + draw->target_count; k++) {
      if (targets[k].positions == NO_ID) continue;
      float16 target = vload16(0, mesh_data + targets[k].positions + c * draw->pitch + at);
      if (targets[k].base_weight != 0.0f) target -= pivot;
      value = fma((float16)(targets[k].weight), target, fma((float16)(targets[k].base_weight), base, value));
    }
    vertices.position[c] = value;
  }
  vertices.clip = to_clip(draw, vertices.position[0], vertices.position[1], vertices.position[2]);
  return vertices;
}

static inline float16 precise_row(global const float* row, global const float* rest, const TwoFloats position[3]) {
  TwoFloats sum = two_floats((float16)(row[3]), (float16)(rest[3]));
  for (int c = 2; c >= 0; c--)
    sum = sum_of(sum, product_of(two_floats((float16)(row[c]), (float16)(rest[c])), position[c]));
  return sum.high;
}

COMPILED_ONCE PreciseVertices two_float_vertices(global const DrawConstants* draw,
                                                 global const PreciseConstants* precise,
                                                 global const TargetConstants* targets, global const float* mesh_data,
                                                 uint at) {
  const float16 zero = 0.0f;
  TwoFloats position[3];
  PreciseVertices vertices;
  FOR_THREE(c) {
    const TwoFloats base = two_floats(vload16(0, mesh_data + draw->positions + c * draw->pitch + at), zero);
    TwoFloats value = base;
    for (uint k = draw->first_target; k < draw->first_target + draw->target_count; k++) {
      if (targets[k].positions == NO_ID) continue;
      const TwoFloats target = two_floats(vload16(0, mesh_data + targets[k].positions + c * draw->pitch + at), zero);
      const TwoFloats weight = two_floats((float16)(targets[k].weight), (float16)(targets[k].weight_rest));
      if (targets[k].base_weight != 0.0f) value = difference_of(value, product_of(weight, base));
      value = sum_of(value, product_of(weight, target));
    }
    position[c] = value;
    vertices.position[c] = value.high;
  }
  vertices.clip.x = precise_row(draw->object_to_clip[0], precise->clip_rest[0], position);
  vertices.clip.y = precise_row(draw->object_to_clip[1], precise->clip_rest[1], position);
  vertices.clip.z = precise_row(draw->object_to_clip[2], precise->clip_rest[2], position);
  vertices.clip.w = precise_row(draw->object_to_clip[3], precise->clip_rest[3], position);
  return vertices;
}

// The morphed positions of 16 vertices, in the form that the draw asks for, and their clip coordinates.
ALWAYS_INLINE ClipPoints clip_points(global const DrawConstants* draw, global const PreciseConstants* precise,
                                     global const TargetConstants* targets, global const float* mesh_data, uint at,
                                     float16* x, float16* y, float16* z) {
  if (draw->flags & (DRAW_PIVOT | DRAW_TWO_FLOAT)) {
    global const PreciseConstants* own = &precise[draw->precise];
    const PreciseVertices vertices = draw->flags & DRAW_PIVOT ? pivot_vertices(draw, own, targets, mesh_data, at)
                                                              : two_float_vertices(draw, own, targets, mesh_data, at);
    *x = vertices.position[0];
    *y = vertices.position[1];
    *z = vertices.position[2];
    return vertices.clip;
  }
  float16 px, py, pz;
  MORPH_3(mesh_data, draw->positions, draw->pitch, at, targets, draw->first_target, draw->target_count, positions, px,
          py, pz)
  *x = px;
  *y = py;
  *z = pz;
  return to_clip(draw, px, py, pz);
}

#endif
