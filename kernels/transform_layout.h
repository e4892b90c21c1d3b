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
  global const real *x, *y, *z;  // records: x alone
} Source;

typedef struct {
  global real *x, *y, *z;
  bool past_cache;
} Target;

// Missing lanes are 0.
#define LOAD_LANES(NAME, scalar)                                           \
  ALWAYS_INLINE scalar##16 NAME(global const scalar* values, long lanes) { \
    if (lanes >= 16) return vload16(0, values);                            \
    scalar padded[16] = {0};                                               \
    for (long lane = 0; lane < lanes; ++lane) padded[lane] = values[lane]; \
    return vload16(0, padded);                                             \
  }
LOAD_LANES(load_reals, real)
LOAD_LANES(load_uints, uint)
LOAD_LANES(load_ulongs, ulong)

// In cache lines, so that 64 bytes of alignment are enough for both precisions.
ALWAYS_INLINE void store_past_cache(real16 value, global real* values) {
#if FRACTION_BITS == 52
  STORE_PAST_CACHE(value.lo, (global double8*)values);
  STORE_PAST_CACHE(value.hi, (global double8*)(values + 8));
#else
  STORE_PAST_CACHE(value, (global float16*)values);
#endif
}

ALWAYS_INLINE void store_lanes(real16 value, global real* values, long lanes, bool past_cache) {
  if (lanes >= 16) {
    if (past_cache)
      store_past_cache(value, values);
    else
      vstore16(value, 0, values);
    return;
  }
  real padded[16];
  vstore16(value, 0, padded);
  for (long lane = 0; lane < lanes; ++lane) values[lane] = padded[lane];
}

ALWAYS_INLINE bool is_cache_line(global const real* values) { return ((size_t)values & 63) == 0; }

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
ALWAYS_INLINE Vertices fields_of_4(real16 a, real16 b, real16 c, real16 d) {
  const real16 xy_ab = SHUFFLE_2(a, b, EVEN_PAIRS), zw_ab = SHUFFLE_2(a, b, ODD_PAIRS);
  const real16 xy_cd = SHUFFLE_2(c, d, EVEN_PAIRS), zw_cd = SHUFFLE_2(c, d, ODD_PAIRS);
  Vertices v;
  v.x = SHUFFLE_2(xy_ab, xy_cd, LOWER_HALVES);
  v.y = SHUFFLE_2(xy_ab, xy_cd, UPPER_HALVES);
  v.z = SHUFFLE_2(zw_ab, zw_cd, LOWER_HALVES);
  v.w = SHUFFLE_2(zw_ab, zw_cd, UPPER_HALVES);
  return v;
}

ALWAYS_INLINE Vertices load_separate(Source in, ulong at, long lanes) {
  Vertices v;
  v.x = load_reals(in.x + at, lanes);
  v.y = load_reals(in.y + at, lanes);
  v.z = load_reals(in.z + at, lanes);
  return v;
}

// Lanes 0, 3, 6 and so on of the first, 1, 4, 7 of the second and 2, 5, 8 of the third.
ALWAYS_INLINE real16 by_thirds(real16 first, real16 second, real16 third) {
  const bits16 is_first = {-1, 0, 0, -1, 0, 0, -1, 0, 0, -1, 0, 0, -1, 0, 0, -1};
  const bits16 is_second = {0, -1, 0, 0, -1, 0, 0, -1, 0, 0, -1, 0, 0, -1, 0, 0};
  return is_first ? first : is_second ? second : third;
}

// Sixteen records of three fill three vectors. A lane is x in exactly one of these, y in another and z in the third:
// x of record i is in lane 3 i mod 16, y and z in the next ones.
ALWAYS_INLINE Vertices load_xyz(Source in, ulong at, long lanes) {
  global const real* records = in.x + 3 * at;
  const real16 a = load_reals(records, 3 * lanes);
  const real16 b = load_reals(records + 16, 3 * lanes - 16);
  const real16 c = load_reals(records + 32, 3 * lanes - 32);
  Vertices v;
  v.x = by_thirds(a, c, b).s0369cf258be147ad;
  v.y = by_thirds(b, a, c).s147ad0369cf258be;
  v.z = by_thirds(c, b, a).s258be147ad0369cf;
  return v;
}

ALWAYS_INLINE Vertices load_xyzw(Source in, ulong at, long lanes) {
  global const real* records = in.x + 4 * at;
  return fields_of_4(load_reals(records, 4 * lanes), load_reals(records + 16, 4 * lanes - 16),
                     load_reals(records + 32, 4 * lanes - 32), load_reals(records + 48, 4 * lanes - 48));
}

ALWAYS_INLINE void store_separate(Vertices v, Target out, ulong at, long lanes) {
  store_lanes(v.x, out.x + at, lanes, out.past_cache);
  store_lanes(v.y, out.y + at, lanes, out.past_cache);
  store_lanes(v.z, out.z + at, lanes, out.past_cache);
}

ALWAYS_INLINE void store_xyz(Vertices v, Target out, ulong at, long lanes) {
  global real* records = out.x + 3 * at;
  const real16 x = v.x.s0b61c72d83e94fa5, y = v.y.s50b61c72d83e94fa, z = v.z.sa50b61c72d83e94f;
  store_lanes(by_thirds(x, y, z), records, 3 * lanes, out.past_cache);
  store_lanes(by_thirds(y, z, x), records + 16, 3 * lanes - 16, out.past_cache);
  store_lanes(by_thirds(z, x, y), records + 32, 3 * lanes - 32, out.past_cache);
}

#define INTERLEAVE_LOW 0, 16, 1, 17, 2, 18, 3, 19, 4, 20, 5, 21, 6, 22, 7, 23
#define INTERLEAVE_HIGH 8, 24, 9, 25, 10, 26, 11, 27, 12, 28, 13, 29, 14, 30, 15, 31
#define PAIRS_LOW 0, 1, 16, 17, 2, 3, 18, 19, 4, 5, 20, 21, 6, 7, 22, 23
#define PAIRS_HIGH 8, 9, 24, 25, 10, 11, 26, 27, 12, 13, 28, 29, 14, 15, 30, 31

ALWAYS_INLINE void store_xyzw(Vertices v, Target out, ulong at, long lanes) {
  global real* records = out.x + 4 * at;
  const real16 xy_low = SHUFFLE_2(v.x, v.y, INTERLEAVE_LOW), xy_high = SHUFFLE_2(v.x, v.y, INTERLEAVE_HIGH);
  const real16 zw_low = SHUFFLE_2(v.z, v.w, INTERLEAVE_LOW), zw_high = SHUFFLE_2(v.z, v.w, INTERLEAVE_HIGH);
  const real16 a = SHUFFLE_2(xy_low, zw_low, PAIRS_LOW), b = SHUFFLE_2(xy_low, zw_low, PAIRS_HIGH);
  const real16 c = SHUFFLE_2(xy_high, zw_high, PAIRS_LOW), d = SHUFFLE_2(xy_high, zw_high, PAIRS_HIGH);
  store_lanes(a, records, 4 * lanes, out.past_cache);
  store_lanes(b, records + 16, 4 * lanes - 16, out.past_cache);
  store_lanes(c, records + 32, 4 * lanes - 32, out.past_cache);
  store_lanes(d, records + 48, 4 * lanes - 48, out.past_cache);
}

#endif
