// Sixteen lanes at a time: masks, gathers, transposes, streaming stores and prefetches.
//
// A lane mask is an int16 with -1 in active lanes, as OpenCL's vector comparisons give it. Only correctly rounded
// operations appear here and in every kernel; min and max are used on NaN-free values only.

#ifndef MORPHCL_VECTOR_H
#define MORPHCL_VECTOR_H

#include "layout.h"

// For functions that pass groups of vectors: as calls on a CPU they would go through memory, at several times the cost.
#ifdef MORPHCL_POCL
#define ALWAYS_INLINE static inline __attribute__((always_inline))
#else
#define ALWAYS_INLINE static inline
#endif

// Loops over three corners or edges, whose variables are to stay in registers.
#define FOR_THREE(i) _Pragma("unroll") for (int i = 0; i < 3; i++)

// For the body of a kernel: PoCL makes several versions of the kernel itself, and should compile its body once.
#ifdef MORPHCL_POCL
#define COMPILED_ONCE static __attribute__((noinline))
#else
#define COMPILED_ONCE static
#endif

// For what a loop seldom needs, so that it costs no registers there.
#ifdef MORPHCL_POCL
#define RARELY_CALLED __attribute__((noinline, cold))
#else
#define RARELY_CALLED
#endif

#define LANE ((int16)(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15))

// a b - c d within 1.5 ulp (Kahan): the rounding error of c d is computed by fma and put back.
ALWAYS_INLINE float16 difference_of_products(float16 a, float16 b, float16 c, float16 d) {
  const float16 product = c * d;
  return fma(a, b, -product) + fma(-c, d, product);
}
static inline float difference_of_two_products(float a, float b, float c, float d) {  // the same of one lane
  const float product = c * d;
  return fma(a, b, -product) + fma(-c, d, product);
}

// A vector whose lanes are looked at one by one. (Read only: a vector load after a store of one lane waits for it.)
typedef union {
  uint16 all;
  uint lane[LANES];
} Lanes;

static inline Lanes lanes_of(uint16 vector) {
  Lanes lanes;
  lanes.all = vector;
  return lanes;
}

// One bit a lane.
#if defined(MORPHCL_POCL) && defined(__SSE2__)
typedef char MaskBytes __attribute__((vector_size(LANES)));
static inline uint bits_of_mask(int16 mask) {
  return (uint)__builtin_ia32_pmovmskb128(__builtin_astype(convert_char16(mask), MaskBytes));
}
static inline bool any_lane(int16 mask) { return bits_of_mask(mask) != 0; }
#else
// The product adds eight bytes, of which each has a bit of its own, into the upper one.
static inline uint bits_of_mask(int16 mask) {
  const ulong2 bits = (as_ulong2(convert_char16(mask)) & 0x8040201008040201UL) * 0x0101010101010101UL >> 56;
  return (uint)bits.x | (uint)bits.y << 8;
}
static inline bool any_lane(int16 mask) {
  const ulong2 bytes = as_ulong2(convert_char16(mask));
  return (bytes.x | bytes.y) != 0;
}
#endif

// The number of the lowest bit that is set; some bit is.
static inline int lowest_bit(uint bits) { return 31 - (int)clz(bits & -bits); }
static inline int first_lane(int16 mask) { return lowest_bit(bits_of_mask(mask)); }

// for (lane of the mask, ascending). The inner loop runs once: it gives the lane its name.
#define FOR_EACH_LANE(lane, mask)                                                          \
  for (uint lane##_bits = bits_of_mask(mask); lane##_bits; lane##_bits &= lane##_bits - 1) \
    for (int lane = lowest_bit(lane##_bits), lane##_once = 1; lane##_once; lane##_once = 0)

static inline float reduce_min(float16 v) {
  float8 a = min(v.lo, v.hi);
  float4 b = min(a.lo, a.hi);
  float2 c = min(b.lo, b.hi);
  return min(c.x, c.y);
}
static inline float reduce_max(float16 v) {
  float8 a = max(v.lo, v.hi);
  float4 b = max(a.lo, a.hi);
  float2 c = max(b.lo, b.hi);
  return max(c.x, c.y);
}

// Sixteen records of four words, by index, as four vectors of one field each. Records are fetched whole and transposed,
// which is several times faster than sixteen gathers a field.
#define RECORDS_OF_4(records, index, i) \
  (int16)(records[index[i]], records[index[i + 1]], records[index[i + 2]], records[index[i + 3]])
#define GATHER_RECORDS(records, index, field0, field1, field2, field3)                       \
  {                                                                                          \
    const int16 r0 = RECORDS_OF_4(records, index, 0), r1 = RECORDS_OF_4(records, index, 4);  \
    const int16 r2 = RECORDS_OF_4(records, index, 8), r3 = RECORDS_OF_4(records, index, 12); \
    field0 = (int16)(r0.s048c, r1.s048c, r2.s048c, r3.s048c);                                \
    field1 = (int16)(r0.s159d, r1.s159d, r2.s159d, r3.s159d);                                \
    field2 = (int16)(r0.s26ae, r1.s26ae, r2.s26ae, r3.s26ae);                                \
    field3 = (int16)(r0.s37bf, r1.s37bf, r2.s37bf, r3.s37bf);                                \
  }

// A store that does not displace what the cache holds, for results that no kernel reads soon.
#ifdef MORPHCL_POCL
#define STREAM_STORE(value, pointer) __builtin_nontemporal_store(value, pointer)
#else
#define STREAM_STORE(value, pointer) (*(pointer) = (value))
#endif

// Asks for what will be read soon: a hint.
#ifdef MORPHCL_POCL
#define PREFETCH(pointer) __builtin_prefetch((const void*)(size_t)(pointer))
#else
#define PREFETCH(pointer) ((void)(pointer))
#endif

// The inverse of GATHER_RECORDS for consecutive records: fields in, sixteen records of four words out.
#define INTERLEAVE_4(f0, f1, f2, f3, a, b, c, d)                                                                      \
  (int16)(f0.s##a, f1.s##a, f2.s##a, f3.s##a, f0.s##b, f1.s##b, f2.s##b, f3.s##b, f0.s##c, f1.s##c, f2.s##c, f3.s##c, \
          f0.s##d, f1.s##d, f2.s##d, f3.s##d)
static inline void store_records(int16 f0, int16 f1, int16 f2, int16 f3, global int4* out) {
  vstore16(INTERLEAVE_4(f0, f1, f2, f3, 0, 1, 2, 3), 0, (global int*)out);
  vstore16(INTERLEAVE_4(f0, f1, f2, f3, 4, 5, 6, 7), 1, (global int*)out);
  vstore16(INTERLEAVE_4(f0, f1, f2, f3, 8, 9, a, b), 2, (global int*)out);
  vstore16(INTERLEAVE_4(f0, f1, f2, f3, c, d, e, f), 3, (global int*)out);
}

// Rows of a matrix applied to points: ((m3 + z m2) + y m1) + x m0, each step one fma.
static inline float16 row_times_point(global const float* row, float16 x, float16 y, float16 z) {
  return fma((float16)(row[0]), x, fma((float16)(row[1]), y, fma((float16)(row[2]), z, (float16)(row[3]))));
}
static inline float16 row_times_vector(global const float* row, float16 x, float16 y, float16 z) {
  return fma((float16)(row[0]), x, fma((float16)(row[1]), y, (float16)(row[2]) * z));
}

#endif
