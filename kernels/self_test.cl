#pragma OPENCL FP_CONTRACT OFF
// self_test: does this device compute what every other kernel relies on?
//
// In:  a, b, c: `count` floats each, count a multiple of 16, no NaN among them.
// Out: results[test * count + i], the bits of each test's result for element i; tests in the order of SelfTest in
//      host/device/self_test_reference.hpp. Halves and integers stand in the low bits.
// The same expressions on one float at a time and on sixteen: compilers treat the two differently.

enum {
  TEST_SUM,
  TEST_DIFFERENCE,
  TEST_PRODUCT,
  TEST_QUOTIENT,
  TEST_SQUARE_ROOT,
  TEST_FUSED_MULTIPLY_ADD,
  TEST_MULTIPLY_THEN_ADD,
  TEST_FLOAT_TO_HALF,
  TEST_HALF_TO_FLOAT,
  TEST_INT_TO_FLOAT,
  TEST_FLOAT_TO_INT,
  TEST_ADD_THEN_SUBTRACT,
  TEST_MULTIPLY_THEN_DIVIDE
};

// The largest float below 2^31, so that no conversion saturates.
#define INT_LIMIT 0x1.fffffep30f

// One work-item an element. Halves are converted sixteen at a time only, here and in all kernels.
kernel void self_test_scalar(global const float* a_values, global const float* b_values, global const float* c_values,
                             uint count, global uint* results) {
  const uint i = get_global_id(0);
  const float a = a_values[i], b = b_values[i], c = c_values[i];
  results[TEST_SUM * count + i] = as_uint(a + b);
  results[TEST_DIFFERENCE * count + i] = as_uint(a - b);
  results[TEST_PRODUCT * count + i] = as_uint(a * b);
  results[TEST_QUOTIENT * count + i] = as_uint(a / b);
  results[TEST_SQUARE_ROOT * count + i] = as_uint(sqrt(fabs(a)));
  results[TEST_FUSED_MULTIPLY_ADD * count + i] = as_uint(fma(a, b, c));
  results[TEST_MULTIPLY_THEN_ADD * count + i] = as_uint(a * b + c);
  results[TEST_INT_TO_FLOAT * count + i] = as_uint(convert_float_rte(as_int(a)));
  const float bounded = a < -INT_LIMIT ? -INT_LIMIT : a > INT_LIMIT ? INT_LIMIT : a;
  results[TEST_FLOAT_TO_INT * count + i] = as_uint(convert_int_sat_rte(bounded));
  results[TEST_ADD_THEN_SUBTRACT * count + i] = as_uint((a + b) - a);
  results[TEST_MULTIPLY_THEN_DIVIDE * count + i] = as_uint(a * b / b);
}

static inline void store_results(uint16 bits, uint test, uint count, uint first, global uint* results) {
  vstore16(bits, 0, results + test * count + first);
}

// One work-item for sixteen elements.
kernel void self_test_vector(global const float* a_values, global const float* b_values, global const float* c_values,
                             uint count, global uint* results) {
  const uint first = get_global_id(0) * 16;
  const float16 a = vload16(0, a_values + first), b = vload16(0, b_values + first), c = vload16(0, c_values + first);
  store_results(as_uint16(a + b), TEST_SUM, count, first, results);
  store_results(as_uint16(a - b), TEST_DIFFERENCE, count, first, results);
  store_results(as_uint16(a * b), TEST_PRODUCT, count, first, results);
  store_results(as_uint16(a / b), TEST_QUOTIENT, count, first, results);
  store_results(as_uint16(sqrt(fabs(a))), TEST_SQUARE_ROOT, count, first, results);
  store_results(as_uint16(fma(a, b, c)), TEST_FUSED_MULTIPLY_ADD, count, first, results);
  store_results(as_uint16(a * b + c), TEST_MULTIPLY_THEN_ADD, count, first, results);
  store_results(as_uint16(convert_float16_rte(as_int16(a))), TEST_INT_TO_FLOAT, count, first, results);
  const float16 raised = a < -INT_LIMIT ? (float16)(-INT_LIMIT) : a;
  const float16 bounded = raised > INT_LIMIT ? (float16)(INT_LIMIT) : raised;
  store_results(as_uint16(convert_int16_sat_rte(bounded)), TEST_FLOAT_TO_INT, count, first, results);
  store_results(as_uint16((a + b) - a), TEST_ADD_THEN_SUBTRACT, count, first, results);
  store_results(as_uint16(a * b / b), TEST_MULTIPLY_THEN_DIVIDE, count, first, results);

  ushort halves[16];
  vstore_half16(a, 0, (half*)halves);
  store_results(convert_uint16(vload16(0, halves)), TEST_FLOAT_TO_HALF, count, first, results);
  // Every finite half: the low 15 bits of a below infinity's, and its sign.
  const uint16 bits = as_uint16(a), magnitude = bits & 0x7fff;
  const uint16 finite = select(magnitude, magnitude & 0x3ff, magnitude >= 0x7c00) | ((bits >> 16) & 0x8000);
  vstore16(convert_ushort16(finite), 0, halves);
  store_results(as_uint16(vload_half16(0, (half*)halves)), TEST_HALF_TO_FLOAT, count, first, results);
}
