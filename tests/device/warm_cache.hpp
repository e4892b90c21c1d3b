// The kernel cache of the test's process, for a child that need not start cold.
#pragma once

#include <cstdlib>

#include "tests/support/child_process.hpp"

namespace morphcl::testing {

inline test_support::Environment warm_cache() {
  const char* folder = std::getenv("MORPHCL_CACHE_DIR");
  return {{"MORPHCL_CACHE_DIR", folder ? folder : "-"}};
}

}  // namespace morphcl::testing
