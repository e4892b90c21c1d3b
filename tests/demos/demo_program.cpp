#include "tests/demos/demo_program.hpp"

namespace morphcl::viewer_test {

test_support::ProcessOptions DemoProgram::options(const std::string& display) const {
  const std::filesystem::path cache = folder_ / "cache";
  test_support::ProcessOptions options;
  options.environment = {{"DISPLAY", display.empty() ? std::nullopt : std::optional(display)},
                         {"WAYLAND_DISPLAY", std::nullopt},
                         {"MORPHCL_CACHE_DIR", cache.string()},
                         {"POCL_CACHE_DIR", (cache / "pocl").string()}};
  options.folder = folder_;
  options.limit = kProgramLimit;
  return options;
}

}  // namespace morphcl::viewer_test
