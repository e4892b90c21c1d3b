#pragma OPENCL FP_CONTRACT OFF
#pragma OPENCL EXTENSION cl_khr_fp64 : enable
// Batch transforms of binary64 vertices: the kernels of transform.h, for devices that have the type.

#define real double
#define real4 double4
#define real16 double16
#define bits16 long16
#define lanes16 ulong16
#define as_bits16 as_long16
#define as_real16 as_double16
#define convert_bits16 convert_long16
#define FRACTION_BITS 52
#define FULL_EXPONENT 2047

#include "transform.h"
