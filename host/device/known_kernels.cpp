#include "host/device/known_kernels.hpp"

#include "host/device/program_cache.hpp"

namespace morphcl {

KnownKernels::KnownKernels(const std::optional<std::filesystem::path>& cache_dir)
    : machine_(machine_identity()), notes_(cache_dir ? std::optional(*cache_dir / "known") : std::nullopt, "known") {}

CacheKey KnownKernels::key(const std::string& source, const std::string& options, const std::string& kernel) const {
  std::vector<std::string> parts = machine_;
  parts.insert(parts.end(), {options, source, kernel});
  return cache_key(parts);
}

bool KnownKernels::has(const std::string& source, const std::string& options, const std::string& kernel) const {
  return notes_.load(key(source, options, kernel)).has_value();
}

void KnownKernels::add(const std::string& source, const std::string& options, const std::string& kernel) const {
  if (!has(source, options, kernel)) notes_.store(key(source, options, kernel), {});
}

}  // namespace morphcl
