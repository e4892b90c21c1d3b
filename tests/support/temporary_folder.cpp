#include "tests/support/temporary_folder.hpp"

#include <stdlib.h>

#include <fstream>
#include <iterator>
#include <stdexcept>

namespace morphcl::test_support {

namespace fs = std::filesystem;

namespace {

std::ifstream opened(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw std::runtime_error("cannot open " + file.string());
  return stream;
}

void write_file(const fs::path& file, std::string_view bytes) {
  std::ofstream stream(file, std::ios::binary);
  stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (!stream.flush()) throw std::runtime_error("cannot write " + file.string());
}

}  // namespace

TemporaryFolder::TemporaryFolder() {
  std::string name = (fs::temp_directory_path() / "morphcl-test-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder can be made at " + name);
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

std::string TemporaryFolder::write(const std::string& name, std::string_view bytes) const {
  const fs::path file = path_ / name;
  fs::create_directories(file.parent_path());
  write_file(file, bytes);
  return file.string();
}

std::set<std::string> TemporaryFolder::names() const {
  std::set<std::string> found;
  for (const auto& entry : fs::directory_iterator(path_)) found.insert(entry.path().filename().string());
  return found;
}

std::set<std::string> TemporaryFolder::files() const {
  constexpr int tries = 100;
  for (int failed = 0;;) {
    std::set<std::string> found;
    try {
      for (const auto& entry : fs::recursive_directory_iterator(path_))
        if (!entry.is_directory()) found.insert(entry.path().lexically_relative(path_).string());
      return found;
    } catch (const fs::filesystem_error&) {  // a program that runs removed the folder that the walk was in
      if (++failed == tries) throw;
    }
  }
}

std::vector<char> bytes_of(const fs::path& file) {
  std::ifstream stream = opened(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::string text_of(const fs::path& file) {
  std::ifstream stream = opened(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

void write_bytes(const fs::path& file, const std::vector<char>& bytes) {
  fs::remove(file);  // some file systems flush a file that is cut and written again
  write_file(file, {bytes.data(), bytes.size()});
}

}  // namespace morphcl::test_support
