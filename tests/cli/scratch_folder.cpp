#include "tests/cli/scratch_folder.hpp"

#include <stdlib.h>

#include <fstream>
#include <stdexcept>

namespace morphcl::cli_test {

namespace fs = std::filesystem;

ScratchFolder::ScratchFolder() {
  std::string name = (fs::temp_directory_path() / "morphcl-cli-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder: " + name);
  folder_ = name;
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

std::string ScratchFolder::plant(const std::string& name, const std::string& content) const {
  fs::create_directories((folder_ / name).parent_path());
  std::ofstream(folder_ / name, std::ios::binary) << content;
  return path(name);
}

std::set<std::string> ScratchFolder::files() const {
  std::set<std::string> found;
  for (const auto& entry : fs::recursive_directory_iterator(folder_))
    if (!entry.is_directory()) found.insert(entry.path().lexically_relative(folder_).string());
  return found;
}

std::size_t ScratchFolder::files_ending_in(const std::string& end) const {
  std::size_t count = 0;
  for (const std::string& name : files())
    if (name.size() >= end.size() && name.compare(name.size() - end.size(), end.size(), end) == 0) ++count;
  return count;
}

std::string read_file(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(stream), {});
}

std::string cube_shot() {
  return R"([image]
size = [32, 18]
compression = "zip"
[frames]
range = "0-4"
fps = 25
[camera]
projection = "perspective"
fovy_degrees = 45.0
near = 0.1
far = 100.0
eye = [3.0, 2.4, 5.1]
target = [0.0, 0.0, 0.0]
[[light]]
direction = [0.4, 0.7, 0.9]
[[object]]
name = "solid"
mesh = "cube"
shading = "flat"
[[object.track]]
target = "translation"
keys = [[0, [0.0, 0.0, 0.0]], [4, [1.0, 0.0, 0.0]]]
)";
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  if (at == std::string::npos) throw std::logic_error("nothing to replace: " + from);
  return text.replace(at, from.size(), to);
}

}  // namespace morphcl::cli_test
