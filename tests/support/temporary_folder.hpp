// A fresh folder that is removed with everything in it, and the content of files.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace morphcl::test_support {

// Below the system's temporary folder, for this user only. Throws std::runtime_error when none can be made.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path operator/(const std::filesystem::path& name) const { return path_ / name; }

  // Writes a file, with the folders above it, and returns its path.
  std::string write(const std::string& name, std::string_view bytes) const;

  // Names of what is directly in it, hidden ones included.
  std::set<std::string> names() const;
  // Every file in it and below, by its path from here.
  std::set<std::string> files() const;

 private:
  std::filesystem::path path_;
};

// The content of a file; throws std::runtime_error when it cannot be opened.
std::vector<char> bytes_of(const std::filesystem::path& file);
std::string text_of(const std::filesystem::path& file);

// Writes a new file, in place of one that is there.
void write_bytes(const std::filesystem::path& file, const std::vector<char>& bytes);

}  // namespace morphcl::test_support
