#pragma OPENCL FP_CONTRACT OFF
// Batch transforms of binary32 vertices: the kernels of transform.h.

typedef float real;
typedef float4 real4;
typedef float16 real16;
typedef int16 bits16;
typedef uint16 lanes16;
#define as_bits16 as_int16
#define as_real16 as_float16
#define convert_bits16 convert_int16
#define FRACTION_BITS 23
#define FULL_EXPONENT 255

#include "transform.h"
