// Batch transforms of vertices, sixteen at a time. Included by transform_f32.cl and transform_f64.cl, which define:
//   real, real4, real16   float or double, and vectors of it
//   lanes16               the unsigned vector as wide as real16, for shuffles
//   bits16, as_bits16     the integer vector as wide as real16, and the cast to it; as_real16 casts back;
//                         convert_bits16 makes a mask of it
//   FRACTION_BITS         stored bits of a real's fraction
//   FULL_EXPONENT         biased exponent of infinity
//
// One kernel for each layout of the vertices and each way to choose matrices:
//   transform_separate, transform_xyz, transform_xyzw        rows[] holds one matrix
//   ..._by_index    vertex i goes through matrix index[i]
//   ..._blended     vertex i goes through the sum of four matrices, weighted by weight[4 i + k]; number k is in bits
//                 16 k to 16 k + 15 of influence[i]
//
// In:  rows: 3 or 4 rows a matrix (kind, transform_kind.h), the factor of (x, y, z, 1) each; `count` vertices.
//      separate: one array a coordinate; xyz, xyzw: one array of records of three or four reals, of which w is no
//      coordinate but goes along unchanged.
// Out: likewise; the same memory as the input is allowed, other overlap is not. A vertex that asks for a matrix past
//      the last one becomes NaN, and *bad_index 1.
// Steps of a block of 16: load and transpose to one vector a coordinate; multiply; divide or normalise; store.
// Work-item i does the vertices from i * vertices_per_item on, a multiple of 16, so that only the last block of all can
// be a partial one, whose missing lanes are neither read nor written. past_cache: not 0 if aligned results should
// bypass the cache. host/batch/transform_reference.cpp is the same arithmetic in plain loops.

#ifndef MORPHCL_TRANSFORM_H
#define MORPHCL_TRANSFORM_H

#include "transform_kind.h"
#include "transform_layout.h"

typedef Vertices Row;  // factors of x, y, z and 1

typedef struct {
  Row x, y, z, w;  // w: of projective matrices only
} Matrices;

typedef struct {
  real16 x, y, z, w;
} Homogeneous;

// ---- arithmetic ----

// ((row.w + z row.z) + y row.y) + x row.x, each step one fma.
ALWAYS_INLINE real16 times(Row row, Vertices p) { return fma(p.x, row.x, fma(p.y, row.y, fma(p.z, row.z, row.w))); }

ALWAYS_INLINE Homogeneous multiply(Matrices m, Vertices p, uint kind) {
  Homogeneous q = {times(m.x, p), times(m.y, p), times(m.z, p), 0};
  if (kind == TRANSFORM_PROJECTIVE) q.w = times(m.w, p);
  return q;
}

ALWAYS_INLINE real16 larger(real16 a, real16 b) { return a > b ? a : b; }

// The vector times the power of two that brings its largest component to [1, 4), or, if that is denormal, as near as
// one factor can. Exact but for components that then are too small to matter. 0 stays 0.
ALWAYS_INLINE Vertices scale_to_one(Vertices v) {
  const real16 largest = larger(fabs(v.x), larger(fabs(v.y), fabs(v.z)));
  const bits16 exponent = as_bits16(largest) >> FRACTION_BITS;
  const real16 factor = as_real16(max((bits16)(FULL_EXPONENT - 1) - exponent, (bits16)(1)) << FRACTION_BITS);
  v.x *= factor;
  v.y *= factor;
  v.z *= factor;
  return v;
}

// Length 1, or 0 for 0.
ALWAYS_INLINE Vertices normalize_vertices(Vertices v) {
  v = scale_to_one(v);
  const real16 length = sqrt(fma(v.x, v.x, fma(v.y, v.y, v.z * v.z)));
  const real16 divisor = length > 0 ? length : (real16)(1);
  v.x /= divisor;
  v.y /= divisor;
  v.z /= divisor;
  return v;
}

// A point with w <= 0, at or behind the eye, has no image: +infinity three times.
ALWAYS_INLINE Vertices divide(Homogeneous q, Vertices v) {
  const bits16 in_front = q.w > 0;
  v.x = in_front ? q.x / q.w : (real16)(INFINITY);
  v.y = in_front ? q.y / q.w : (real16)(INFINITY);
  v.z = in_front ? q.z / q.w : (real16)(INFINITY);
  return v;
}

// Normals are scaled before they are multiplied, so that nothing overflows, and again after, so that squares do not
// underflow.
ALWAYS_INLINE Vertices before_multiplying(Vertices v, uint kind) {
  return kind == TRANSFORM_NORMALS ? scale_to_one(v) : v;
}

ALWAYS_INLINE Vertices after_multiplying(Homogeneous q, Vertices v, uint kind) {
  if (kind == TRANSFORM_PROJECTIVE) return divide(q, v);
  v.x = q.x;
  v.y = q.y;
  v.z = q.z;
  return kind == TRANSFORM_NORMALS ? normalize_vertices(v) : v;
}

// ---- matrices ----

ALWAYS_INLINE Row same_row(real4 row) {
  Row all = {(real16)(row.x), (real16)(row.y), (real16)(row.z), (real16)(row.w)};
  return all;
}

ALWAYS_INLINE Matrices same_matrix(global const real4* rows, uint kind) {
  Matrices m = {same_row(rows[0]), same_row(rows[1]), same_row(rows[2]), same_row(rows[2])};
  if (kind == TRANSFORM_PROJECTIVE) m.w = same_row(rows[3]);
  return m;
}

#define FOUR_ROWS(a, b, c, d) (real16)(rows[at.s##a], rows[at.s##b], rows[at.s##c], rows[at.s##d])

// Rows are fetched whole and transposed, which is several times faster than a gather for each of the factors.
ALWAYS_INLINE Row gather_row(global const real4* rows, uint16 at) {
  const real16 a = FOUR_ROWS(0, 1, 2, 3), b = FOUR_ROWS(4, 5, 6, 7);
  const real16 c = FOUR_ROWS(8, 9, a, b), d = FOUR_ROWS(c, d, e, f);
  return fields_of_4(a, b, c, d);
}

ALWAYS_INLINE Matrices gather_matrices(global const real4* rows, uint16 index, uint kind) {
  const uint16 first = index * (uint16)(kind == TRANSFORM_PROJECTIVE ? 4 : 3);
  Matrices m;
  m.x = gather_row(rows, first);
  m.y = gather_row(rows, first + (uint16)(1));
  m.z = gather_row(rows, first + (uint16)(2));
  m.w = m.z;
  if (kind == TRANSFORM_PROJECTIVE) m.w = gather_row(rows, first + (uint16)(3));
  return m;
}

// NaN where a matrix was asked for that is not there.
ALWAYS_INLINE Vertices without_bad(Vertices v, int16 bad, global uint* bad_index) {
  if (!any_lane(bad)) return v;
  *bad_index = 1;
  const bits16 lanes = convert_bits16(bad);
  v.x = lanes ? (real16)(NAN) : v.x;
  v.y = lanes ? (real16)(NAN) : v.y;
  v.z = lanes ? (real16)(NAN) : v.z;
  return v;
}

// ---- blocks of sixteen ----

ALWAYS_INLINE Vertices transform_same(Matrices m, uint kind, Vertices v) {
  const Vertices p = before_multiplying(v, kind);
  return after_multiplying(multiply(m, p, kind), v, kind);
}

ALWAYS_INLINE Vertices transform_indexed(global const real4* rows, uint matrix_count, uint kind, Vertices v,
                                         global const uint* index, long lanes, global uint* bad_index) {
  const uint16 asked = load_uints(index, lanes), last = matrix_count - 1;
  const Matrices m = gather_matrices(rows, min(asked, last), kind);
  return without_bad(transform_same(m, kind, v), asked > last, bad_index);
}

// The first product rounded, then one fma for each of the other three.
ALWAYS_INLINE Homogeneous add_weighted(Homogeneous sum, real16 weight, Homogeneous q) {
  sum.x = fma(weight, q.x, sum.x);
  sum.y = fma(weight, q.y, sum.y);
  sum.z = fma(weight, q.z, sum.z);
  sum.w = fma(weight, q.w, sum.w);
  return sum;
}

ALWAYS_INLINE Vertices transform_blended(global const real4* rows, uint matrix_count, uint kind, Vertices v,
                                         global const ulong* influence, Source weights, ulong at, long lanes,
                                         global uint* bad_index) {
  const ulong16 asked = load_ulongs(influence + at, lanes);
  const Vertices weight = load_xyzw(weights, at, lanes);
  const real16 weight_of[4] = {weight.x, weight.y, weight.z, weight.w};

  // -0 is the sum of nothing: adding the first product to it changes no bit of that.
  Homogeneous sum = {-0.0f, -0.0f, -0.0f, -0.0f};
  int16 bad = 0;
  const uint16 last = matrix_count - 1;
  for (int k = 0; k < 4; ++k) {
    const uint16 matrix = convert_uint16(asked >> (ulong)(16 * k)) & (uint16)(0xffff);
    bad |= matrix > last;
    const Matrices m = gather_matrices(rows, min(matrix, last), kind);
    sum = add_weighted(sum, weight_of[k], multiply(m, v, kind));
  }
  return without_bad(after_multiplying(sum, v, kind), bad, bad_index);
}

// ---- kernels ----

#define ARRAYS                                                                                              \
  global const real *x, global const real *y, global const real *z, global real *out_x, global real *out_y, \
      global real *out_z
#define ARRAYS_SOURCE \
  { x, y, z }
#define ARRAYS_TARGET \
  { out_x, out_y, out_z, past_cache != 0 && is_cache_line(out_x) && is_cache_line(out_y) && is_cache_line(out_z) }

#define RECORDS global const real *records, global real *out
#define RECORDS_SOURCE \
  { records, 0, 0 }
#define RECORDS_TARGET \
  { out, 0, 0, past_cache != 0 && is_cache_line(out) }

#define SHARE ulong count, ulong vertices_per_item, uint past_cache
#define FOR_EACH_BLOCK(at)                                                                               \
  const ulong begin = get_global_id(0) * vertices_per_item, end = min(begin + vertices_per_item, count); \
  for (ulong at = begin; at < end; at += 16)

#define TRANSFORM_KERNELS(LAYOUT, VERTICES)                                                                            \
  kernel void transform_##LAYOUT(global const real4* rows, uint kind, VERTICES, SHARE) {                               \
    const Source in = VERTICES##_SOURCE;                                                                               \
    const Target to = VERTICES##_TARGET;                                                                               \
    const Matrices matrix = same_matrix(rows, kind);                                                                   \
    FOR_EACH_BLOCK(at) {                                                                                               \
      const long lanes = end - at;                                                                                     \
      store_##LAYOUT(transform_same(matrix, kind, load_##LAYOUT(in, at, lanes)), to, at, lanes);                       \
    }                                                                                                                  \
  }                                                                                                                    \
  kernel void transform_##LAYOUT##_by_index(global const real4* rows, uint kind, uint matrix_count,                    \
                                            global uint* bad_index, global const uint* index, VERTICES, SHARE) {       \
    const Source in = VERTICES##_SOURCE;                                                                               \
    const Target to = VERTICES##_TARGET;                                                                               \
    FOR_EACH_BLOCK(at) {                                                                                               \
      const long lanes = end - at;                                                                                     \
      const Vertices v = load_##LAYOUT(in, at, lanes);                                                                 \
      store_##LAYOUT(transform_indexed(rows, matrix_count, kind, v, index + at, lanes, bad_index), to, at, lanes);     \
    }                                                                                                                  \
  }                                                                                                                    \
  kernel void transform_##LAYOUT##_blended(global const real4* rows, uint kind, uint matrix_count,                     \
                                           global uint* bad_index, global const ulong* influence,                      \
                                           global const real* weight, VERTICES, SHARE) {                               \
    const Source in = VERTICES##_SOURCE, weights = {weight, 0, 0};                                                     \
    const Target to = VERTICES##_TARGET;                                                                               \
    FOR_EACH_BLOCK(at) {                                                                                               \
      const long lanes = end - at;                                                                                     \
      const Vertices v = load_##LAYOUT(in, at, lanes);                                                                 \
      store_##LAYOUT(transform_blended(rows, matrix_count, kind, v, influence, weights, at, lanes, bad_index), to, at, \
                     lanes);                                                                                           \
    }                                                                                                                  \
  }

TRANSFORM_KERNELS(separate, ARRAYS)
TRANSFORM_KERNELS(xyz, RECORDS)
TRANSFORM_KERNELS(xyzw, RECORDS)

#endif
