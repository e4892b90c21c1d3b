#include "host/math/require_number.hpp"

#include <fmt/core.h>

#include "morphcl/error.hpp"

namespace morphcl {

void require_number(bool holds, const char* name, double value, const char* right) {
  if (!holds) throw Error(ErrorKind::usage, "", fmt::format("{} is {}; it must be {}", name, value, right));
}

}  // namespace morphcl
