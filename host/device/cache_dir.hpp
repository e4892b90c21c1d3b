// Where compiled kernels are kept between runs.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace morphcl {

// `option` as in SessionOptions::cache_dir. Nothing for "-", and where no variable names a folder. MORPHCL_CACHE_DIR
// may be "-" too. The folder need not exist.
std::optional<std::filesystem::path> choose_cache_dir(const std::string& option);

// "-" was said where choose_cache_dir() looks for a name: no cache is wanted.
bool cache_is_switched_off(const std::string& option);

// Gives PoCL a folder for its own cache that lives as long as the process, unless POCL_CACHE_DIR is set. PoCL aborts
// the process over a damaged file in it, and a killed process leaves such files; what is worth keeping is in our own
// cache, with checksums. The folder is a temporary one, else one below `cache_dir`, else one where temporary ones
// usually are. Error(no_device) when none of them can be written, or POCL_CACHE_DIR cannot: PoCL aborts then. Must run
// before the first OpenCL call; only the first call that succeeds has an effect.
void place_pocl_cache(const std::optional<std::filesystem::path>& cache_dir);

// The folder that it has made. Nothing before, and where POCL_CACHE_DIR was set.
std::optional<std::filesystem::path> placed_pocl_cache();

// The folder is placed, or would be: what PoCL leaves there is kept in our cache, without asking PoCL for binaries.
bool pocl_cache_is_ours();

}  // namespace morphcl
