// How batches of vertices lie in memory: sixteen at a time, to and from one vector a coordinate.
//
// separate: one array a coordinate. xyz, xyzw: one array of records of three or four reals, which are loaded as they
// lie and transposed in registers. `lanes` is how many vertices there are from the address on: where it is below 16,
// the missing ones are neither read nor written. The types real and real16 are those of transform.h.

#ifndef MORPHCL_TRANSFORM_LAYOUT_H
#define MORPHCL_TRANSFORM_LAYOUT_H

#include "layout.h"
#include "vector.h"

typedef struct {
  real16 x, y, z, w;  // w: what records of four carry along
} Vertices;

typedef struct {
  real16 a, b, c, d;  // d: of records of four
} Records;            // sixteen, as they lie

typedef struct {
  global const real *x, *y, *z;  // records: x alone
} Source;

typedef struct {
  global real *x, *y, *z;
  bool streams;
} Target;

// ---- streaming stores ----

ALWAYS_INLINE bool is_cache_line(global const real* values) { return ((size_t)values & 63) == 0; }

// In cache lines, so that 64 bytes of alignment are enough for both precisions.
ALWAYS_INLINE void stream_store(real16 value, global real* values) {
#if FRACTION_BITS == 52
  STREAM_STORE(value.lo, (global double8*)values);
  STREAM_STORE(value.hi, (global double8*)(values + 8));
#else
  STREAM_STORE(value, (global float16*)values);
#endif
}

// ---- separate arrays ----

ALWAYS_INLINE Vertices load_separate(Source in, ulong at, long lanes) {
  Vertices v;
  if (lanes >= 16) {
    v.x = vload16(0, in.x + at);
    v.y = vload16(0, in.y + at);
    v.z = vload16(0, in.z + at);
    return v;
  }
  real x[16] = {0}, y[16] = {0}, z[16] = {0};
  for (long lane = 0; lane < lanes; ++lane) {
    x[lane] = in.x[at + lane];
    y[lane] = in.y[at + lane];
    z[lane] = in.z[at + lane];
  }
  v.x = vload16(0, x);
  v.y = vload16(0, y);
  v.z = vload16(0, z);
  return v;
}

ALWAYS_INLINE void store_separate(Vertices v, Target out, ulong at, long lanes) {
  if (lanes >= 16 && out.streams) {
    stream_store(v.x, out.x + at);
    stream_store(v.y, out.y + at);
    stream_store(v.z, out.z + at);
  } else if (lanes >= 16) {
    vstore16(v.x, 0, out.x + at);
    vstore16(v.y, 0, out.y + at);
    vstore16(v.z, 0, out.z + at);
  } else {
    real x[16], y[16], z[16];
    vstore16(v.x, 0, x);
    vstore16(v.y, 0, y);
    vstore16(v.z, 0, z);
    for (long lane = 0; lane < lanes; ++lane) {
      out.x[at + lane] = x[lane];
      out.y[at + lane] = y[lane];
      out.z[at + lane] = z[lane];
    }
  }
}

// ---- records ----

ALWAYS_INLINE Records load_records(global const real* records, long fields, long lanes) {
  Records r;
  if (lanes >= 16) {
    r.a = vload16(0, records);
    r.b = vload16(1, records);
    r.c = vload16(2, records);
    if (fields == 4) r.d = vload16(3, records);
    return r;
  }
  real padded[64] = {0};
  for (long i = 0; i < fields * lanes; ++i) padded[i] = records[i];
  r.a = vload16(0, padded);
  r.b = vload16(1, padded);
  r.c = vload16(2, padded);
  r.d = vload16(3, padded);
  return r;
}

ALWAYS_INLINE void store_records_of(long fields, Records r, global real* records, long lanes, bool streams) {
  if (lanes >= 16 && streams) {
    stream_store(r.a, records);
    stream_store(r.b, records + 16);
    stream_store(r.c, records + 32);
    if (fields == 4) stream_store(r.d, records + 48);
  } else if (lanes >= 16) {
    vstore16(r.a, 0, records);
    vstore16(r.b, 1, records);
    vstore16(r.c, 2, records);
    if (fields == 4) vstore16(r.d, 3, records);
  } else {
    real padded[64];
    vstore16(r.a, 0, padded);
    vstore16(r.b, 1, padded);
    vstore16(r.c, 2, padded);
    if (fields == 4) vstore16(r.d, 3, padded);
    for (long i = 0; i < fields * lanes; ++i) records[i] = padded[i];
  }
}

// Lanes 0, 3, 6 and so on of the first, 1, 4, 7 of the second and 2, 5, 8 of the third.
ALWAYS_INLINE real16 blend_of_3(real16 first, real16 second, real16 third) {
  const bits16 is_first = {-1, 0, 0, -1, 0, 0, -1, 0, 0, -1, 0, 0, -1, 0, 0, -1};
  const bits16 is_second = {0, -1, 0, 0, -1, 0, 0, -1, 0, 0, -1, 0, 0, -1, 0, 0};
  return is_first ? first : is_second ? second : third;
}

// Sixteen records of three fill three vectors. A lane is x in exactly one of these, y in another and z in the third:
// x of record i is in lane 3 i mod 16, y and z in the next ones.
ALWAYS_INLINE Vertices load_xyz(Source in, ulong at, long lanes) {
  const Records r = load_records(in.x + 3 * at, 3, lanes);
  Vertices v;
  v.x = blend_of_3(r.a, r.c, r.b).s0369cf258be147ad;
  v.y = blend_of_3(r.b, r.a, r.c).s147ad0369cf258be;
  v.z = blend_of_3(r.c, r.b, r.a).s258be147ad0369cf;
  return v;
}

ALWAYS_INLINE void store_xyz(Vertices v, Target out, ulong at, long lanes) {
  const real16 x = v.x.s0b61c72d83e94fa5, y = v.y.s50b61c72d83e94fa, z = v.z.sa50b61c72d83e94f;
  Records r;
  r.a = blend_of_3(x, y, z);
  r.b = blend_of_3(y, z, x);
  r.c = blend_of_3(z, x, y);
  store_records_of(3, r, out.x + 3 * at, lanes, out.streams);
}

// Any lanes of two vectors, 0 to 15 of the first and 16 to 31 of the second. Swizzles that are put together say the
// same, but take a compiler for CPUs several instructions for each.
#ifdef MORPHCL_POCL
#define SHUFFLE_2(a, b, ...) __builtin_shufflevector(a, b, __VA_ARGS__)
#else
#define SHUFFLE_2(a, b, ...) shuffle2(a, b, (lanes16)(__VA_ARGS__))
#endif
#define EVEN_PAIRS 0, 4, 8, 12, 16, 20, 24, 28, 1, 5, 9, 13, 17, 21, 25, 29
#define ODD_PAIRS 2, 6, 10, 14, 18, 22, 26, 30, 3, 7, 11, 15, 19, 23, 27, 31
#define LOWER_HALVES 0, 1, 2, 3, 4, 5, 6, 7, 16, 17, 18, 19, 20, 21, 22, 23
#define UPPER_HALVES 8, 9, 10, 11, 12, 13, 14, 15, 24, 25, 26, 27, 28, 29, 30, 31

// Sixteen records of four fields, four in each vector, as one vector a field.
ALWAYS_INLINE Vertices fields_of_4(Records r) {
  const real16 xy_ab = SHUFFLE_2(r.a, r.b, EVEN_PAIRS), zw_ab = SHUFFLE_2(r.a, r.b, ODD_PAIRS);
  const real16 xy_cd = SHUFFLE_2(r.c, r.d, EVEN_PAIRS), zw_cd = SHUFFLE_2(r.c, r.d, ODD_PAIRS);
  Vertices v;
  v.x = SHUFFLE_2(xy_ab, xy_cd, LOWER_HALVES);
  v.y = SHUFFLE_2(xy_ab, xy_cd, UPPER_HALVES);
  v.z = SHUFFLE_2(zw_ab, zw_cd, LOWER_HALVES);
  v.w = SHUFFLE_2(zw_ab, zw_cd, UPPER_HALVES);
  return v;
}

#define INTERLEAVE_LOW 0, 16, 1, 17, 2, 18, 3, 19, 4, 20, 5, 21, 6, 22, 7, 23
#define INTERLEAVE_HIGH 8, 24, 9, 25, 10, 26, 11, 27, 12, 28, 13, 29, 14, 30, 15, 31
#define PAIRS_LOW 0, 1, 16, 17, 2, 3, 18, 19, 4, 5, 20, 21, 6, 7, 22, 23
#define PAIRS_HIGH 8, 9, 24, 25, 10, 11, 26, 27, 12, 13, 28, 29, 14, 15, 30, 31

ALWAYS_INLINE Records records_of_4(Vertices v) {
  const real16 xy_low = SHUFFLE_2(v.x, v.y, INTERLEAVE_LOW), xy_high = SHUFFLE_2(v.x, v.y, INTERLEAVE_HIGH);
  const real16 zw_low = SHUFFLE_2(v.z, v.w, INTERLEAVE_LOW), zw_high = SHUFFLE_2(v.z, v.w, INTERLEAVE_HIGH);
  Records r;
  r.a = SHUFFLE_2(xy_low, zw_low, PAIRS_LOW);
  r.b = SHUFFLE_2(xy_low, zw_low, PAIRS_HIGH);
  r.c = SHUFFLE_2(xy_high, zw_high, PAIRS_LOW);
  r.d = SHUFFLE_2(xy_high, zw_high, PAIRS_HIGH);
  return r;
}

ALWAYS_INLINE Vertices load_xyzw(Source in, ulong at, long lanes) {
  return fields_of_4(load_records(in.x + 4 * at, 4, lanes));
}

ALWAYS_INLINE void store_xyzw(Vertices v, Target out, ulong at, long lanes) {
  store_records_of(4, records_of_4(v), out.x + 4 * at, lanes, out.streams);
}

#endif
