#include "demos/viewer/shot_path.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "morphcl/error.hpp"

namespace morphcl::viewer {

std::string find_shot(const std::string& name) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  const fs::path installed = program.parent_path().parent_path() / MORPHCL_INSTALLED_SHOTS / name;
  const fs::path source = fs::path(MORPHCL_SOURCE_SHOTS) / name;
  for (const fs::path& candidate : {installed, source}) {
    if (fs::is_regular_file(candidate, error)) return candidate.string();
  }
  throw Error(ErrorKind::cannot_read, name,
              fmt::format("neither {} nor {} exists; give the shot with --shot", installed.string(), source.string()));
}

}  // namespace morphcl::viewer
