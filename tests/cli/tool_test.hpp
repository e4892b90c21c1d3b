// A fresh folder for a test of the tool, with files that the test writes.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <string>

#include "tests/support/temporary_folder.hpp"

namespace morphcl::cli_test {

class ToolTest : public testing::Test {
 private:
  const test_support::TemporaryFolder temporary_;

 protected:
  std::string path(const std::string& name) const { return temporary_ / name; }
  // Writes a file below the folder and returns its path.
  std::string plant(const std::string& name, const std::string& content) const {
    return temporary_.write(name, content);
  }
  // Every file below the folder by its path from there.
  std::set<std::string> files() const { return temporary_.files(); }
  std::size_t files_ending_in(const std::string& end) const {
    const std::set<std::string> all = files();
    return static_cast<std::size_t>(
        std::count_if(all.begin(), all.end(), [&](const std::string& name) { return name.ends_with(end); }));
  }

  const std::filesystem::path& folder_ = temporary_.path();
};

}  // namespace morphcl::cli_test
