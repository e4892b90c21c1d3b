#pragma OPENCL FP_CONTRACT OFF
#pragma OPENCL EXTENSION cl_khr_fp64 : enable
// A binary32 point times the rows of an affine binary64 matrix, rounded once; see accuracy_points_f32.cl.
//
// In:  planes: x, y, z, one array after the other, `count` each. constants: 12 doubles, row after row.
// Out: results: x, y, z likewise. One work-item a point.

kernel void in_fp64(global const float* planes, global const double* constants, global float* results, uint count) {
  const size_t i = get_global_id(0);
  if (i >= count) return;
  const double x = planes[i], y = planes[i + count], z = planes[i + 2 * (size_t)count];
  for (int row = 0; row < 3; ++row) {
    global const double* m = constants + 4 * row;
    results[i + row * (size_t)count] = (float)(x * m[0] + y * m[1] + z * m[2] + m[3]);
  }
}
