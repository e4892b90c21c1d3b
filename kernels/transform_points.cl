#pragma OPENCL FP_CONTRACT OFF
// transform_points: points, vectors and normals through one matrix, sixteen at a time.
//
// In:  x, y, z: `count` floats each (structure of arrays); the matrix as rows, translation in .w.
// Out: out_x, out_y, out_z, likewise; the same memory as the input is allowed, other overlap is not.
// Work-item i takes the points from i * points_per_item on; points_per_item is a multiple of 16, so that only the last
// block of all can be a partial one, whose missing lanes are neither read nor written.
// past_cache: not 0 if results should bypass the cache, which needs outputs aligned to 64 bytes.
// host/device/transform_points_reference.cpp is the same arithmetic in plain loops.

#include "vector.h"

typedef struct {
  float16 x, y, z;
} Block;

static inline float16 load_lanes(global const float* values, ulong lanes) {
  if (lanes >= 16) return vload16(0, values);
  float padded[16] = {0};
  for (ulong lane = 0; lane < lanes; ++lane) padded[lane] = values[lane];
  return vload16(0, padded);
}

static inline void store_lanes(float16 value, global float* values, ulong lanes, uint past_cache) {
  if (lanes >= 16) {
    if (past_cache)
      STORE_PAST_CACHE(value, (global float16*)values);
    else
      vstore16(value, 0, values);
    return;
  }
  float padded[16];
  vstore16(value, 0, padded);
  for (ulong lane = 0; lane < lanes; ++lane) values[lane] = padded[lane];
}

static inline Block load_block(global const float* x, global const float* y, global const float* z, ulong at, ulong end) {
  Block block;
  block.x = load_lanes(x + at, end - at);
  block.y = load_lanes(y + at, end - at);
  block.z = load_lanes(z + at, end - at);
  return block;
}

static inline void store_block(Block block, global float* x, global float* y, global float* z, ulong at, ulong end,
                               uint past_cache) {
  store_lanes(block.x, x + at, end - at, past_cache);
  store_lanes(block.y, y + at, end - at, past_cache);
  store_lanes(block.z, z + at, end - at, past_cache);
}

// ((row.w + z row.z) + y row.y) + x row.x, each step one fma.
static inline float16 point_row(float4 row, Block p) {
  return fma(p.x, (float16)(row.x), fma(p.y, (float16)(row.y), fma(p.z, (float16)(row.z), (float16)(row.w))));
}

static inline float16 vector_row(float4 row, Block v) {
  return fma(v.x, (float16)(row.x), fma(v.y, (float16)(row.y), v.z * (float16)(row.z)));
}

static inline float16 larger(float16 a, float16 b) { return a > b ? a : b; }

// The vector times the power of two that brings its largest component to [1, 4), or, if that is denormal, as near as one
// factor can. Exact but for components that then are too small to matter. 0 stays 0.
static inline Block scale_to_one(Block v) {
  const float16 largest = larger(fabs(v.x), larger(fabs(v.y), fabs(v.z)));
  const int16 exponent = as_int16(largest) >> 23;
  const float16 factor = as_float16(max((int16)(254) - exponent, (int16)(1)) << 23);
  v.x *= factor;
  v.y *= factor;
  v.z *= factor;
  return v;
}

// Length 1, or 0 for 0.
static inline Block normalize_block(Block v) {
  v = scale_to_one(v);
  const float16 length = sqrt(fma(v.x, v.x, fma(v.y, v.y, v.z * v.z)));
  const float16 divisor = length > 0.0f ? length : (float16)(1.0f);
  v.x /= divisor;
  v.y /= divisor;
  v.z /= divisor;
  return v;
}

kernel void transform_points(float4 row_x, float4 row_y, float4 row_z, global const float* x, global const float* y,
                             global const float* z, global float* out_x, global float* out_y, global float* out_z,
                             ulong count, ulong points_per_item, uint past_cache) {
  const ulong begin = get_global_id(0) * points_per_item, end = min(begin + points_per_item, count);
  for (ulong at = begin; at < end; at += 16) {
    const Block p = load_block(x, y, z, at, end);
    const Block q = {point_row(row_x, p), point_row(row_y, p), point_row(row_z, p)};
    store_block(q, out_x, out_y, out_z, at, end, past_cache);
  }
}

// Divides by w = row_w p. A point with w <= 0, at or behind the eye, has no image: all three results are +infinity.
kernel void project_points(float4 row_x, float4 row_y, float4 row_z, float4 row_w, global const float* x,
                           global const float* y, global const float* z, global float* out_x, global float* out_y,
                           global float* out_z, ulong count, ulong points_per_item, uint past_cache) {
  const ulong begin = get_global_id(0) * points_per_item, end = min(begin + points_per_item, count);
  for (ulong at = begin; at < end; at += 16) {
    const Block p = load_block(x, y, z, at, end);
    const float16 w = point_row(row_w, p);
    const int16 in_front = w > 0.0f;
    const Block q = {in_front ? point_row(row_x, p) / w : (float16)(INFINITY),
                     in_front ? point_row(row_y, p) / w : (float16)(INFINITY),
                     in_front ? point_row(row_z, p) / w : (float16)(INFINITY)};
    store_block(q, out_x, out_y, out_z, at, end, past_cache);
  }
}

kernel void transform_vectors(float4 row_x, float4 row_y, float4 row_z, global const float* x, global const float* y,
                              global const float* z, global float* out_x, global float* out_y, global float* out_z,
                              ulong count, ulong points_per_item, uint past_cache) {
  const ulong begin = get_global_id(0) * points_per_item, end = min(begin + points_per_item, count);
  for (ulong at = begin; at < end; at += 16) {
    const Block v = load_block(x, y, z, at, end);
    const Block q = {vector_row(row_x, v), vector_row(row_y, v), vector_row(row_z, v)};
    store_block(q, out_x, out_y, out_z, at, end, past_cache);
  }
}

// The rows are those of normal_rows() in host/device/normal_rows.hpp. Scaled before, so that nothing overflows, and
// again after, so that squares do not underflow.
kernel void transform_normals(float4 row_x, float4 row_y, float4 row_z, global const float* x, global const float* y,
                              global const float* z, global float* out_x, global float* out_y, global float* out_z,
                              ulong count, ulong points_per_item, uint past_cache) {
  const ulong begin = get_global_id(0) * points_per_item, end = min(begin + points_per_item, count);
  for (ulong at = begin; at < end; at += 16) {
    const Block n = scale_to_one(load_block(x, y, z, at, end));
    const Block q = {vector_row(row_x, n), vector_row(row_y, n), vector_row(row_z, n)};
    store_block(normalize_block(q), out_x, out_y, out_z, at, end, past_cache);
  }
}
