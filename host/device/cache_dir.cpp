#include "host/device/cache_dir.hpp"

#include <unistd.h>

#include <cstdlib>
#include <mutex>

namespace morphcl {

namespace fs = std::filesystem;

namespace {

const char* environment(const char* name) {
  const char* value = std::getenv(name);
  return value && *value ? value : nullptr;
}

// Created for the user alone where missing: what is compiled in here will be run.
bool is_writable_folder(const fs::path& folder) {
  std::error_code failure;
  if (fs::create_directories(folder, failure)) fs::permissions(folder, fs::perms::owner_all, failure);
  return fs::is_directory(folder, failure) && access(folder.c_str(), R_OK | W_OK | X_OK) == 0;
}

struct TemporaryFolder {
  fs::path path;
  pid_t owner = 0;

  ~TemporaryFolder() {
    std::error_code failure;
    // A forked child that exits must leave its parent's folder alone.
    if (!path.empty() && owner == getpid()) fs::remove_all(path, failure);
  }
};

fs::path make_temporary_folder() {
  static TemporaryFolder folder;
  std::error_code failure;
  std::string name = (fs::temp_directory_path(failure) / "morphcl-XXXXXX").string();
  if (!failure && mkdtemp(name.data())) {
    folder.path = name;
    folder.owner = getpid();
  }
  return folder.path;
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
    fs::path folder;
    if (cache_dir) folder = fs::absolute(*cache_dir) / "pocl";
    if (folder.empty() || !is_writable_folder(folder)) folder = make_temporary_folder();
    if (!folder.empty()) setenv("POCL_CACHE_DIR", folder.c_str(), 1);
  });
}

}  // namespace morphcl
