#pragma OPENCL FP_CONTRACT OFF
// Ways to interpolate between two values in binary32, for the report of errors against run times.
//
// In:  planes, one array after the other, `count` numbers each: the values a and b and the parameter t; for the
//      perspective-correct forms a1, w1, a2, w2 and t.
// Out: results: one number an element. One work-item an element; lab/accuracy/operations/lerp.cpp and interpolation.cpp
//      are the same arithmetic on the host.

#define ARGUMENTS global const float *planes, global const float *constants, global float *results, uint count

#define LOAD_ENDS                    \
  const size_t i = get_global_id(0); \
  if (i >= count) return;            \
  const float a = planes[i], b = planes[i + count], t = planes[i + 2 * (size_t)count];

kernel void lerp_difference(ARGUMENTS) {
  LOAD_ENDS
  results[i] = a + t * (b - a);
}

kernel void lerp_weights(ARGUMENTS) {
  LOAD_ENDS
  results[i] = (1.0f - t) * a + t * b;
}

kernel void lerp_fused(ARGUMENTS) {
  LOAD_ENDS
  results[i] = fma(t, b, fma(-t, a, a));
}

#define LOAD_CORNERS                                                                                          \
  const size_t i = get_global_id(0), pitch = count;                                                           \
  if (i >= count) return;                                                                                     \
  const float a1 = planes[i], w1 = planes[i + pitch], a2 = planes[i + 2 * pitch], w2 = planes[i + 3 * pitch], \
              t = planes[i + 4 * pitch];

kernel void perspective_difference(ARGUMENTS) {
  LOAD_CORNERS
  const float p1 = a1 / w1, p2 = a2 / w2, q1 = 1.0f / w1, q2 = 1.0f / w2;
  results[i] = (p1 + t * (p2 - p1)) / (q1 + t * (q2 - q1));
}

kernel void perspective_weights(ARGUMENTS) {
  LOAD_CORNERS
  const float k1 = (1.0f - t) * (1.0f / w1), k2 = t * (1.0f / w2);
  results[i] = (k1 * a1 + k2 * a2) / (k1 + k2);
}

kernel void perspective_products(ARGUMENTS) {
  LOAD_CORNERS
  const float k1 = w2 * (1.0f - t), k2 = w1 * t;
  results[i] = (a1 * k1 + a2 * k2) / (k1 + k2);
}
