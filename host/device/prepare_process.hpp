// What must happen in a process before its first OpenCL call; the public entry is prepare_process in session.hpp.
#pragma once

#include <string_view>

#include "morphcl/error.hpp"

namespace morphcl {

// Calls prepare_process(threads) unless the process was prepared before.
void ensure_process_prepared(int threads = 0);

// Error(no_device): why, and the package that provides a device.
Error no_usable_device(std::string_view reason);

}  // namespace morphcl
