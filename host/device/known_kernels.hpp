// Which kernels the cache holds for the default device of this machine, told without opening a device: that takes tens
// of milliseconds, in which a small frame is drawn.
//
// A hint. The driver may have been replaced since, or a binary be gone; who opens the device finds out.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "host/device/disk_cache.hpp"

namespace morphcl {

// Stands for a kernel: the device has passed the self-test.
inline constexpr const char* self_test_note = "self_test";

// For threads, as long as none assigns to it.
class KnownKernels {
 public:
  explicit KnownKernels(const std::optional<std::filesystem::path>& cache_dir);

  bool has(const std::string& source, const std::string& options, const std::string& kernel) const;
  // Does nothing when it is there.
  void add(const std::string& source, const std::string& options, const std::string& kernel) const;

 private:
  CacheKey key(const std::string& source, const std::string& options, const std::string& kernel) const;

  std::vector<std::string> machine_;
  DiskCache notes_;
};

}  // namespace morphcl
