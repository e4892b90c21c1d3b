// The built demos, in a fresh folder.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "tests/demos/program_process.hpp"

namespace morphcl::viewer_test {

inline constexpr const char* kMorphDemo = MORPHCL_TEST_MORPH_DEMO;
inline constexpr const char* kTeapots = MORPHCL_TEST_TEAPOTS;

// Long enough to compile every kernel on a busy machine, short enough to find a program that hangs.
inline constexpr std::chrono::seconds kProgramLimit{120};

class DemoProgram : public ::testing::Test {
 protected:
  DemoProgram();
  ~DemoProgram() override;

  // A display only where `environment` names one; the kernel caches are below the folder.
  std::vector<std::string> lines(const std::string& text) const;
  Environment environment(const std::string& display = "") const;

  std::filesystem::path folder_;  // removed at the end
};

}  // namespace morphcl::viewer_test
