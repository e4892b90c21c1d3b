// Where compiled kernels are kept between runs.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace morphcl {

// `option` as in SessionOptions::cache_dir. Nothing for "-", and where no variable names a folder. MORPHCL_CACHE_DIR
// may be "-" too. The folder need not exist.
std::optional<std::filesystem::path> choose_cache_dir(const std::string& option);

// Gives PoCL a folder for its own cache, unless POCL_CACHE_DIR is set: `cache_dir`/pocl, or, where that cannot be
// written (PoCL then finds no device at all), a fresh temporary folder that the process removes when it exits. Must run
// before the first OpenCL call; only the first call has an effect.
void place_pocl_cache(const std::optional<std::filesystem::path>& cache_dir);

}  // namespace morphcl
