// A fresh folder for one test, removed at its end, with small shots to put in it.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <set>
#include <string>

namespace morphcl::cli_test {

class ScratchFolder : public testing::Test {
 protected:
  ScratchFolder();
  ~ScratchFolder() override;

  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  // Writes a file below the folder and returns its path.
  std::string plant(const std::string& name, const std::string& content) const;
  // Every file below the folder by its path from there.
  std::set<std::string> files() const;
  std::size_t files_ending_in(const std::string& end) const;

  std::filesystem::path folder_;
};

std::string read_file(const std::filesystem::path& path);

// A cube that turns: 32x18 pixels, frames 0 to 4, every line one that a test may replace.
std::string cube_shot();

// `text` with the first `from` replaced; throws when there is none, so that a test cannot test nothing.
std::string replaced(std::string text, const std::string& from, const std::string& to);

}  // namespace morphcl::cli_test
