#include "host/device/cache_dir.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <mutex>
#include <vector>

#include "host/device/driver_needs.hpp"
#include "host/device/prepare_process.hpp"
#include "host/device/process_folder.hpp"

namespace morphcl {

namespace fs = std::filesystem;

namespace {

const char* environment(const char* name) {
  const char* value = std::getenv(name);
  return value && *value ? value : nullptr;
}

std::string named_cache_dir(const std::string& option) {
  const char* own = environment("MORPHCL_CACHE_DIR");
  return option.empty() && own != nullptr ? own : option;
}

std::optional<fs::path>& placed_folder() {
  static std::optional<fs::path> folder;
  return folder;
}

// The first folder that PoCL can work in; what is wrong with each when there is none.
fs::path make_driver_folder(const std::optional<fs::path>& cache_dir) {
  std::vector<fs::path> parents;
  const char* named = environment("TMPDIR");
  if (named != nullptr) parents.emplace_back(named);
  parents.emplace_back("/tmp");
  std::error_code failure;
  if (cache_dir) parents.push_back(fs::absolute(*cache_dir, failure));
  for (const char* usual : {"/var/tmp", "/dev/shm"}) parents.emplace_back(usual);
  std::string troubles;
  for (const fs::path& parent : parents) {
    // A temporary folder that is not there is a mistake of who named it, and not made.
    std::string trouble = named != nullptr && parent == named && !fs::is_directory(parent, failure)
                              ? "there is no such folder"
                              : folder_trouble(parent);
    if (trouble.empty())
      if (const fs::path folder = make_process_folder(parent, "morphcl-pocl"); !folder.empty()) return folder;
    if (trouble.empty()) trouble = "no folder can be made and locked there";
    troubles += fmt::format("{}{}: {}", troubles.empty() ? "" : ", ", parent.string(), trouble);
  }
  throw no_usable_device(
      fmt::format("there is no folder for its {} MB of temporary files ({})", driver_folder_bytes >> 20, troubles),
      "make room, or name another one with TMPDIR");
}

}  // namespace

bool cache_is_switched_off(const std::string& option) { return named_cache_dir(option) == "-"; }

std::optional<fs::path> choose_cache_dir(const std::string& option) {
  const std::string folder = named_cache_dir(option);
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
    if (const char* users = environment("POCL_CACHE_DIR")) {
      if (const std::string trouble = folder_trouble(users); !trouble.empty())
        throw no_usable_device(fmt::format("POCL_CACHE_DIR is {}: {}", users, trouble),
                               "name a folder that can be written, or unset it");
      return;
    }
    const fs::path folder = make_driver_folder(cache_dir);
    setenv("POCL_CACHE_DIR", folder.c_str(), 1);
    placed_folder() = folder;
  });
}

std::optional<fs::path> placed_pocl_cache() { return placed_folder(); }

bool pocl_cache_is_ours() { return placed_folder() || environment("POCL_CACHE_DIR") == nullptr; }

}  // namespace morphcl
