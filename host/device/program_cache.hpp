// Compiled programs and self-test verdicts on disk.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "host/device/disk_cache.hpp"
#include "host/device/opencl.hpp"

namespace morphcl {

// What of it is known without a device: the processor's model and features, and the POCL_ variables that change code.
std::vector<std::string> machine_identity();

// Everything besides the source and the options that decides what a compiler makes for this device here: device, driver
// and platform with their versions, the processor's model and features (a home folder may be shared by unlike machines)
// and the POCL_ variables that change code.
std::vector<std::string> compiler_identity(const cl::Device& device, const cl::Platform& platform);

class ProgramCache {
 public:
  ProgramCache(const std::optional<std::filesystem::path>& cache_dir, std::vector<std::string> compiler_identity);

  // A program built from a binary in which `kernel` is ready to run, or nothing if there is none or the driver does not
  // take it. Kernels that were stored together get the same program. Not for two threads at a time.
  std::optional<cl::Program> load(const cl::Context& context, const std::string& source, const std::string& options,
                                  const std::string& kernel);

  // Stores the binary for each of `kernels`, which must have run: PoCL's binaries hold the work-group functions
  // compiled so far, and a kernel without one would be compiled again by every process that loads the binary. False if
  // there are none, the driver gives no binary, or the folder does not take it; then `trouble` gets the reason.
  bool store(const cl::Program& program, const std::string& source, const std::string& options,
             const std::set<std::string>& kernels, std::string* trouble = nullptr) const;

  // Whether the self-test is known to pass for this program. Only passing is remembered. The key names the compiler,
  // the processor and the test, and what it vouches for is the same as what the cached binaries were made by: a
  // compiler or device that differs in anything is another key, and is tested.
  bool is_known_identical(const std::string& self_test_source, const std::string& options) const;
  void remember_identical(const std::string& self_test_source, const std::string& options) const;

 private:
  CacheKey key(const std::string& source, const std::string& options, const std::string& name) const;

  std::vector<std::string> compiler_identity_;
  DiskCache binaries_, verdicts_;
  std::map<std::string, cl::Program> loaded_;  // by the binary's hash
};

}  // namespace morphcl
