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
// Steps of a group of 16: load and transpose to one vector a coordinate; multiply; divide or normalise; store.
// A work-item does `runs` runs of run_length vertices that follow each other, a group of each in turn: that many
// streams keep the memory busy where one array alone would not. run_length is a multiple of 16, so that only the last
// group of all can be a partial one, whose missing lanes are neither read nor written. stream_stores: not 0 if
// aligned results should bypass the cache. host/batch/transform_reference.cpp is the same arithmetic in plain loops.

#ifndef MORPHCL_TRANSFORM_H
#define MORPHCL_TRANSFORM_H

#include "transform_constants.h"
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

// Missing lanes are 0.
#define LOAD_LANES(NAME, scalar)                                           \
  ALWAYS_INLINE scalar##16 NAME(global const scalar* values, long lanes) { \
    if (lanes >= 16) return vload16(0, values);                            \
    scalar padded[16] = {0};                                               \
    for (long lane = 0; lane < lanes; ++lane) padded[lane] = values[lane]; \
    return vload16(0, padded);                                             \
  }
LOAD_LANES(load_uints, uint)
LOAD_LANES(load_ulongs, ulong)

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

#define FOUR_ROWS(a, b, c, d) (real16)(rows[at.lane[a]], rows[at.lane[b]], rows[at.lane[c]], rows[at.lane[d]])

// Rows are fetched whole and transposed, which is several times faster than a gather for each of the factors.
ALWAYS_INLINE Row gather_row(global const real4* rows, Lanes at) {
  const Records r = {FOUR_ROWS(0, 1, 2, 3), FOUR_ROWS(4, 5, 6, 7), FOUR_ROWS(8, 9, 10, 11), FOUR_ROWS(12, 13, 14, 15)};
  return fields_of_4(r);
}

ALWAYS_INLINE Matrices gather_matrices(global const real4* rows, uint16 index, uint kind) {
  const Lanes first = lanes_of(index * (uint16)(kind == TRANSFORM_PROJECTIVE ? 4 : 3));
  Matrices m;
  m.x = gather_row(rows, first);
  m.y = gather_row(rows + 1, first);
  m.z = gather_row(rows + 2, first);
  m.w = m.z;
  if (kind == TRANSFORM_PROJECTIVE) m.w = gather_row(rows + 3, first);
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

// ---- groups of sixteen ----

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
                                         global const ulong* influence, global const real* weights, ulong at,
                                         long lanes, global uint* bad_index) {
  const ulong16 asked = load_ulongs(influence + at, lanes);
  const Vertices weight = fields_of_4(load_records(weights + 4 * at, 4, lanes));
  const real16 weight_of[4] = {weight.x, weight.y, weight.z, weight.w};

  // -0 is the sum of nothing: adding the first product to it changes no bit of that.
  Homogeneous sum = {-0.0f, -0.0f, -0.0f, -0.0f};
  int16 bad = 0;
  const uint16 last = matrix_count - 1;
  for (int k = 0; k < 4; ++k) {
    const uint16 matrix = convert_uint16(asked >> (ulong)(16 * k)) & (uint16)(0xffff);
    bad |= matrix > last;
    const Matrices m = gather_matrices(rows, min(matrix, last), kind);
    // With w, of affine matrices too, which do not use it: over a branch here LLVM 18 ends the process when PoCL 6
    // makes a binary (PoCL issue 1608).
    sum = add_weighted(sum, weight_of[k], multiply(m, v, TRANSFORM_PROJECTIVE));
  }
  return without_bad(after_multiplying(sum, v, kind), bad, bad_index);
}

// ---- kernels ----

// Each layout: parameters, their names, and the two as structs.
#define ARRAYS_PARAMETERS                                                                                   \
  global const real *x, global const real *y, global const real *z, global real *out_x, global real *out_y, \
      global real *out_z
#define ARRAYS_NAMES x, y, z, out_x, out_y, out_z
#define ARRAYS_SOURCE {x, y, z}
#define ARRAYS_TARGET   \
  {out_x, out_y, out_z, \
   constants.stream_stores != 0 && is_cache_line(out_x) && is_cache_line(out_y) && is_cache_line(out_z)}

#define RECORDS_PARAMETERS global const real *records, global real *out
#define RECORDS_NAMES records, out
#define RECORDS_SOURCE {records, 0, 0}
#define RECORDS_TARGET {out, 0, 0, constants.stream_stores != 0 && is_cache_line(out)}

// Each way to choose matrices: parameters, their names, and what becomes of a group v.
#define ONE_PARAMETERS
#define ONE_NAMES
#define ONE_TRANSFORM(v) transform_same(same_matrix(rows, kind), kind, v)

#define INDEX_PARAMETERS global uint *bad_index, global const uint *restrict index,
#define INDEX_NAMES bad_index, index,
#define INDEX_TRANSFORM(v) transform_indexed(rows, constants.matrix_count, kind, v, index + at, lanes, bad_index)

#define BLEND_PARAMETERS \
  global uint *bad_index, global const ulong *restrict influence, global const real *restrict weight,
#define BLEND_NAMES bad_index, influence, weight,
#define BLEND_TRANSFORM(v) \
  transform_blended(rows, constants.matrix_count, kind, v, influence, weight, at, lanes, bad_index)

#define TRANSFORM_KERNEL(NAME, LAYOUT, VERTICES, CHOICE)                                                           \
  COMPILED_ONCE void NAME##_of_item(ulong item, TransformConstants constants, global const real4* restrict rows,   \
                                    CHOICE##_PARAMETERS VERTICES##_PARAMETERS) {                                   \
    const Source in = VERTICES##_SOURCE;                                                                           \
    const Target to = VERTICES##_TARGET;                                                                           \
    const ulong count = constants.count, run_length = constants.run_length;                                        \
    const uint kind = constants.kind;                                                                              \
    const ulong begin = item * run_length * constants.runs, end = min(begin + run_length * constants.runs, count); \
    for (ulong done = 0; done < run_length; done += 16)                                                            \
      for (ulong at = begin + done; at < end; at += run_length) {                                                  \
        const long lanes = count - at;                                                                             \
        const Vertices v = load_##LAYOUT(in, at, lanes);                                                           \
        store_##LAYOUT(CHOICE##_TRANSFORM(v), to, at, lanes);                                                      \
      }                                                                                                            \
  }                                                                                                                \
  kernel void NAME(TransformConstants constants, global const real4* rows,                                         \
                   CHOICE##_PARAMETERS VERTICES##_PARAMETERS) {                                                    \
    NAME##_of_item(get_global_id(0), constants, rows, CHOICE##_NAMES VERTICES##_NAMES);                            \
  }

TRANSFORM_KERNEL(transform_separate, separate, ARRAYS, ONE)
TRANSFORM_KERNEL(transform_separate_by_index, separate, ARRAYS, INDEX)
TRANSFORM_KERNEL(transform_separate_blended, separate, ARRAYS, BLEND)
TRANSFORM_KERNEL(transform_xyz, xyz, RECORDS, ONE)
TRANSFORM_KERNEL(transform_xyz_by_index, xyz, RECORDS, INDEX)
TRANSFORM_KERNEL(transform_xyz_blended, xyz, RECORDS, BLEND)
TRANSFORM_KERNEL(transform_xyzw, xyzw, RECORDS, ONE)
TRANSFORM_KERNEL(transform_xyzw_by_index, xyzw, RECORDS, INDEX)
TRANSFORM_KERNEL(transform_xyzw_blended, xyzw, RECORDS, BLEND)

#endif
