#pragma OPENCL FP_CONTRACT OFF
#pragma OPENCL EXTENSION cl_khr_fp64 : enable
// Batch transforms of binary64 vertices: the kernels of transform.h, for devices that have the type.

typedef double real;
typedef double4 real4;
typedef double16 real16;
typedef long16 bits16;
typedef ulong16 lanes16;
#define as_bits16 as_long16
#define as_real16 as_double16
#define convert_bits16 convert_long16
#define FRACTION_BITS 52
#define FULL_EXPONENT 2047

#include "transform.h"
