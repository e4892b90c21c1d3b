#include "host/device/cache_dir.hpp"

#include <cstdlib>
#include <mutex>

#include "host/device/process_folder.hpp"

namespace morphcl {

namespace fs = std::filesystem;

namespace {

const char* environment(const char* name) {
  const char* value = std::getenv(name);
  return value && *value ? value : nullptr;
}

}  // namespace

std::optional<fs::path> choose_cache_dir(const std::string& option) {
  std::string folder = option;
  if (const char* own = environment("MORPHCL_CACHE_DIR"); folder.empty() && own) folder = own;
  if (folder == "-") return std::nullopt;
  if (!folder.empty()) return fs::path(folder);
  // The XDG specification has relative values ignored.
  if (const char* xdg = environment("XDG_CACHE_HOME"); xdg && *xdg == '/') return fs::path(xdg) / "morphcl";
  if (const char* home = environment("HOME")) return fs::path(home) / ".cache" / "morphcl";
  return std::nullopt;
}

void place_pocl_cache(const std::optional<fs::path>& cache_dir) {
  static std::once_flag once;
  std::call_once(once, [&] {
    if (environment("POCL_CACHE_DIR")) return;
    std::error_code failure;
    fs::path folder = make_process_folder(fs::temp_directory_path(failure), "morphcl-pocl");
    if (folder.empty() && cache_dir && (fs::create_directories(*cache_dir, failure), !failure))
      folder = make_process_folder(fs::absolute(*cache_dir), "pocl");
    if (!folder.empty()) setenv("POCL_CACHE_DIR", folder.c_str(), 1);
  });
}

}  // namespace morphcl
