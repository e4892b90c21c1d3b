// What the self-test asks a device, and the right answers, computed on the host.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace morphcl {

// In the order of kernels/self_test.cl.
enum class SelfTest {
  sum,
  difference,
  product,
  quotient,
  square_root,
  fused_multiply_add,
  multiply_then_add,  // must round twice: a compiler that contracts a*b+c fails here
  float_to_half,
  half_to_float,
  int_to_float,
  float_to_int,
  add_then_subtract,  // (a+b)-a is b for a compiler that takes sums for associative
  multiply_then_divide,
};
constexpr int self_test_count = 13;

const char* self_test_name(SelfTest test);  // "a*b+c"
bool is_vector_only(SelfTest test);         // halves are converted sixteen at a time only

// Three operands for each element; every array has self_test_elements values and no NaN: zeros of both signs,
// denormals, the ends of the float and half ranges, ties between halves, infinities, each with each; then operands for
// which fused and unfused results differ; then bits from a fixed sequence.
struct SelfTestOperands {
  std::vector<float> a, b, c;
};
constexpr std::size_t self_test_elements = 1024;
SelfTestOperands self_test_operands();

// The bits of the right result, by IEEE arithmetic of the host (halves by integer arithmetic).
std::uint32_t self_test_answer(SelfTest test, float a, float b, float c);

// Both results' distance in units of the last place of the result's format; 0 for equal bits and for two NaNs.
std::uint64_t self_test_distance(SelfTest test, std::uint32_t answer, std::uint32_t result);

}  // namespace morphcl
