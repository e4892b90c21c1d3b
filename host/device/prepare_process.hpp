// What must happen in a process before its first OpenCL call; the public entry is prepare_process in session.hpp.
#pragma once

#include <string_view>

#include "morphcl/error.hpp"

namespace morphcl {

// Calls prepare_process(threads) unless the process was prepared before.
void ensure_process_prepared(int threads = 0);

// Two names: PoCL reads the first up to 3.1 and the second from 4.0 on.
constexpr const char* pocl_thread_variables[] = {"POCL_MAX_PTHREAD_COUNT", "POCL_CPU_MAX_CU_COUNT"};

// Error(no_device): why, and what helps; else the package that provides a device.
Error no_usable_device(std::string_view reason, std::string_view remedy = "");

}  // namespace morphcl
