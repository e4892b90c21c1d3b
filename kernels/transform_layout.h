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
LOAD_LANES(load_ushorts, ushort)

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

// Sixteen records of four fields, four in each vector, as one vector a field.
#define FIELDS_OF_4(type, a, b, c, d, field0, field1, field2, field3) \
  field0 = (type)(a.s048c, b.s048c, c.s048c, d.s048c);                \
  field1 = (type)(a.s159d, b.s159d, c.s159d, d.s159d);                \
  field2 = (type)(a.s26ae, b.s26ae, c.s26ae, d.s26ae);                \
  field3 = (type)(a.s37bf, b.s37bf, c.s37bf, d.s37bf);

ALWAYS_INLINE Vertices load_separate(Source in, ulong at, long lanes) {
  Vertices v;
  v.x = load_reals(in.x + at, lanes);
  v.y = load_reals(in.y + at, lanes);
  v.z = load_reals(in.z + at, lanes);
  return v;
}

ALWAYS_INLINE Vertices load_xyz(Source in, ulong at, long lanes) {
  global const real* records = in.x + 3 * at;
  const real16 a = load_reals(records, 3 * lanes);
  const real16 b = load_reals(records + 16, 3 * lanes - 16);
  const real16 c = load_reals(records + 32, 3 * lanes - 32);
  Vertices v;
  v.x = (real16)(a.s0369, a.scf, b.s258b, b.se, c.s147a, c.sd);
  v.y = (real16)(a.s147a, a.sd, b.s0369, b.scf, c.s258b, c.se);
  v.z = (real16)(a.s258b, a.se, b.s147a, b.sd, c.s0369, c.scf);
  return v;
}

ALWAYS_INLINE Vertices load_xyzw(Source in, ulong at, long lanes) {
  global const real* records = in.x + 4 * at;
  const real16 a = load_reals(records, 4 * lanes), b = load_reals(records + 16, 4 * lanes - 16);
  const real16 c = load_reals(records + 32, 4 * lanes - 32), d = load_reals(records + 48, 4 * lanes - 48);
  Vertices v;
  FIELDS_OF_4(real16, a, b, c, d, v.x, v.y, v.z, v.w)
  return v;
}

ALWAYS_INLINE void store_separate(Vertices v, Target out, ulong at, long lanes) {
  store_lanes(v.x, out.x + at, lanes, out.past_cache);
  store_lanes(v.y, out.y + at, lanes, out.past_cache);
  store_lanes(v.z, out.z + at, lanes, out.past_cache);
}

#define XYZ(v, i) v.x.s##i, v.y.s##i, v.z.s##i
#define XYZW(v, i) v.x.s##i, v.y.s##i, v.z.s##i, v.w.s##i

ALWAYS_INLINE void store_xyz(Vertices v, Target out, ulong at, long lanes) {
  global real* records = out.x + 3 * at;
  const real16 a = (real16)(XYZ(v, 0), XYZ(v, 1), XYZ(v, 2), XYZ(v, 3), XYZ(v, 4), v.x.s5);
  const real16 b = (real16)(v.y.s5, v.z.s5, XYZ(v, 6), XYZ(v, 7), XYZ(v, 8), XYZ(v, 9), v.x.sa, v.y.sa);
  const real16 c = (real16)(v.z.sa, XYZ(v, b), XYZ(v, c), XYZ(v, d), XYZ(v, e), XYZ(v, f));
  store_lanes(a, records, 3 * lanes, out.past_cache);
  store_lanes(b, records + 16, 3 * lanes - 16, out.past_cache);
  store_lanes(c, records + 32, 3 * lanes - 32, out.past_cache);
}

ALWAYS_INLINE void store_xyzw(Vertices v, Target out, ulong at, long lanes) {
  global real* records = out.x + 4 * at;
  const real16 a = (real16)(XYZW(v, 0), XYZW(v, 1), XYZW(v, 2), XYZW(v, 3));
  const real16 b = (real16)(XYZW(v, 4), XYZW(v, 5), XYZW(v, 6), XYZW(v, 7));
  const real16 c = (real16)(XYZW(v, 8), XYZW(v, 9), XYZW(v, a), XYZW(v, b));
  const real16 d = (real16)(XYZW(v, c), XYZW(v, d), XYZW(v, e), XYZW(v, f));
  store_lanes(a, records, 4 * lanes, out.past_cache);
  store_lanes(b, records + 16, 4 * lanes - 16, out.past_cache);
  store_lanes(c, records + 32, 4 * lanes - 32, out.past_cache);
  store_lanes(d, records + 48, 4 * lanes - 48, out.past_cache);
}

#endif
