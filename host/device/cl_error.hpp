// Failures of OpenCL calls as morphcl errors.
#pragma once

#include <string>
#include <string_view>
#include <utility>

#include "host/device/opencl.hpp"
#include "morphcl/error.hpp"

namespace morphcl {

// "CL_OUT_OF_RESOURCES" for -5; "unknown code -12345" for what the standard does not name.
std::string cl_code_name(cl_int code);

// One line: what was being done, the call that failed, the name of its code, and what would help. The kind is no_device
// where another device or a smaller picture would do (out of memory, device lost), else internal.
Error device_error(const cl::Error& error, std::string_view doing);

// Runs `call` and turns a cl::Error into device_error(error, doing).
template <class Call>
decltype(auto) checked(std::string_view doing, Call&& call) {
  try {
    return std::forward<Call>(call)();
  } catch (const cl::Error& error) {
    throw device_error(error, doing);
  }
}

}  // namespace morphcl
