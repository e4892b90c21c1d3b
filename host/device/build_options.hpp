// The options that every kernel is compiled with.
#pragma once

#include <string>

#include "host/device/opencl.hpp"

namespace morphcl {

// OpenCL C 1.2; correctly rounded division and square root where the device has them (the self-test finds out about the
// others); MORPHCL_POCL where the compiler is the clang of PoCL. Nothing that relaxes arithmetic.
std::string build_options(const cl::Device& device, const cl::Platform& platform);

}  // namespace morphcl
