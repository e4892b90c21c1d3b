// Test data that lies outside the repository, in a folder that an environment variable names.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>

namespace morphcl::test_support {

// Throws std::runtime_error where the variable is not set: it was when the tests were configured.
inline std::filesystem::path test_data(const char* variable) {
  const char* folder = std::getenv(variable);
  if (!folder) throw std::runtime_error(std::string(variable) + " is not set; it names the folder of the test data");
  return folder;
}

}  // namespace morphcl::test_support
