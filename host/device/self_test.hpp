// The self-test that decides whether a device may promise the same bits as every other.
#pragma once

#include <cstdint>
#include <string>

#include "host/device/kernel.hpp"
#include "host/device/opencl.hpp"
#include "morphcl/session.hpp"

namespace morphcl {

struct SelfTestResult {
  Verdict verdict = Verdict::identical;
  std::uint64_t max_ulp = 0;  // the largest difference
  std::string detail;         // "" or the operations that differ: how many results, and the largest difference
};

// Runs both kernels of self_test.cl on the operands of self_test_reference.hpp and compares every bit. A launch that
// fails is an Error.
SelfTestResult run_self_test(const cl::Context& context, const cl::CommandQueue& queue, const Kernel& scalar,
                             const Kernel& vector);

}  // namespace morphcl
