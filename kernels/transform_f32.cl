#pragma OPENCL FP_CONTRACT OFF
// Batch transforms of binary32 vertices: the kernels of transform.h.

#define real float
#define real4 float4
#define real16 float16
#define bits16 int16
#define lanes16 uint16
#define as_bits16 as_int16
#define as_real16 as_float16
#define convert_bits16 convert_int16
#define FRACTION_BITS 23
#define FULL_EXPONENT 255

#include "transform.h"
