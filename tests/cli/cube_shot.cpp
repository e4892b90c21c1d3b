#include "tests/cli/cube_shot.hpp"

#include <stdexcept>

namespace morphcl::cli_test {

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
