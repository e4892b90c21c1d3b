// The error of a call whose arguments do not fit together.
#pragma once

#include <string>

#include "morphcl/error.hpp"

namespace morphcl {

inline Error usage_error(const std::string& message) { return Error(ErrorKind::usage, "", message); }

}  // namespace morphcl
