#pragma OPENCL FP_CONTRACT OFF
// Ways to multiply a point by the rows of an affine matrix in binary32, for the report of errors against run times.
//
// In:  planes: x, y, z, one array after the other, `count` each. constants: 12 floats, row after row.
// Out: results: x, y, z likewise. One work-item a point; lab/accuracy/operations/point_transform.cpp is the same
//      arithmetic on the host.

#define POINT_ARGUMENTS global const float *planes, global const float *constants, global float *results, uint count

#define LOAD_POINT                   \
  const size_t i = get_global_id(0); \
  if (i >= count) return;            \
  const float v[3] = {planes[i], planes[i + count], planes[i + 2 * (size_t)count]};

kernel void multiply_add(POINT_ARGUMENTS) {
  LOAD_POINT
  for (int row = 0; row < 3; ++row) {
    global const float* m = constants + 4 * row;
    results[i + row * (size_t)count] = v[0] * m[0] + v[1] * m[1] + v[2] * m[2] + m[3];
  }
}

// constants go on with the pivot, which takes the place of the translations.
kernel void pivot_relative(POINT_ARGUMENTS) {
  LOAD_POINT
  global const float* pivot = constants + 12;
  const float x = v[0] - pivot[0], y = v[1] - pivot[1], z = v[2] - pivot[2];
  for (int row = 0; row < 3; ++row) {
    global const float* m = constants + 4 * row;
    results[i + row * (size_t)count] = fma(x, m[0], fma(y, m[1], z * m[2])) + pivot[row];
  }
}

// constants go on with what rounding the 12 entries left, rounded.
kernel void two_float(POINT_ARGUMENTS) {
  LOAD_POINT
  for (int row = 0; row < 3; ++row) {
    global const float *high = constants + 4 * row, *low = constants + 12 + 4 * row;
    float sum = high[3], rest = low[3];
    for (int k = 2; k >= 0; --k) {
      const float product = v[k] * high[k];
      rest += fma(v[k], high[k], -product) + v[k] * low[k];
      const float next = sum + product, part = next - sum;
      rest += (sum - (next - part)) + (product - part);
      sum = next;
    }
    results[i + row * (size_t)count] = sum + rest;
  }
}
