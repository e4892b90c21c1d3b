// The built demos, in a fresh folder.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "tests/support/child_process.hpp"
#include "tests/support/temporary_folder.hpp"

namespace morphcl::viewer_test {

inline constexpr const char* kMorphDemo = MORPHCL_TEST_MORPH_DEMO;
inline constexpr const char* kTeapots = MORPHCL_TEST_TEAPOTS;

// Long enough to compile every kernel on a busy machine, short enough to find a program that hangs.
inline constexpr std::chrono::seconds kProgramLimit{120};

class DemoProgram : public ::testing::Test {
 private:
  const test_support::TemporaryFolder temporary_;

 protected:
  // No display where `display` is empty; it runs in the folder, and the kernel caches are below it.
  test_support::ProcessOptions options(const std::string& display = "") const;

  const std::filesystem::path& folder_ = temporary_.path();
};

}  // namespace morphcl::viewer_test
