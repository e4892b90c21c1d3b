#include "tests/demos/demo_program.hpp"

#include <stdlib.h>

#include <sstream>
#include <stdexcept>

namespace morphcl::viewer_test {

DemoProgram::DemoProgram() {
  std::string name = (std::filesystem::temp_directory_path() / "morphcl-demo-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
  folder_ = name;
}

DemoProgram::~DemoProgram() {
  std::error_code ignored;
  std::filesystem::remove_all(folder_, ignored);
}

std::vector<std::string> DemoProgram::lines(const std::string& text) const {
  std::vector<std::string> result;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) result.push_back(line);
  return result;
}

Environment DemoProgram::environment(const std::string& display) const {
  return {{"DISPLAY", display},
          {"WAYLAND_DISPLAY", ""},
          {"MORPHCL_CACHE_DIR", (folder_ / "cache").string()},
          {"POCL_CACHE_DIR", (folder_ / "cache" / "pocl").string()}};
}

}  // namespace morphcl::viewer_test
