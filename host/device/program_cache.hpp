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

struct BuiltProgram {
  cl::Program program;
  std::filesystem::path files;  // PoCL's, below its folder; empty where they are not known
};

class ProgramCache {
 public:
  // `pocl_folder`: of PoCL's own cache, where it lives and dies with this process.
  ProgramCache(const std::optional<std::filesystem::path>& cache_dir, std::vector<std::string> compiler_identity,
               std::optional<std::filesystem::path> pocl_folder = std::nullopt);

  // A program in which `kernel` is ready to run, or nothing if there is none or the driver does not take it: from a
  // binary, else from PoCL's files. Kernels that were stored together get the same program. Not for two threads at a
  // time.
  std::optional<cl::Program> load(const cl::Context& context, const std::string& source, const std::string& options,
                                  const std::string& kernel);
  bool has_binary(const std::string& source, const std::string& options, const std::string& kernel) const;

  // Throws cl::BuildError.
  BuiltProgram build(const cl::Context& context, const std::string& source, const std::string& options);

  // Stores what build() has made for each of `kernels`, which must have run: what is compiled is the work-group
  // functions that were asked for so far, and a kernel without one would be compiled again by every later process.
  // PoCL's files, where it has left any, else the binary. False if there are no kernels, the driver gives no binary, or
  // the folder does not take it; then `trouble` gets the reason.
  bool store(const BuiltProgram& built, const std::string& source, const std::string& options,
             const std::set<std::string>& kernels, std::string* trouble = nullptr) const;

  // The same by the binary, which is loaded in half the time. PoCL compiles every kernel once more for it.
  bool store_binary(const cl::Program& program, const std::string& source, const std::string& options,
                    const std::set<std::string>& kernels, std::string* trouble = nullptr) const;

  // Whether the self-test is known to pass for this program. Only passing is remembered. The key names the compiler,
  // the processor and the test, and what it vouches for is the same as what the cached binaries were made by: a
  // compiler or device that differs in anything is another key, and is tested.
  bool is_known_identical(const std::string& self_test_source, const std::string& options) const;
  void remember_identical(const std::string& self_test_source, const std::string& options) const;

 private:
  CacheKey key(const std::string& source, const std::string& options, const std::string& name) const;
  std::optional<cl::Program> load_binary(const cl::Context& context, const CacheKey& key, const std::string& options);
  std::optional<cl::Program> load_files(const cl::Context& context, const CacheKey& key, const std::string& source,
                                        const std::string& options);

  std::vector<std::string> compiler_identity_;
  std::optional<std::filesystem::path> pocl_folder_;
  DiskCache binaries_, files_, verdicts_;
  std::map<std::string, cl::Program> loaded_;  // by the hash of what was loaded
  std::map<std::string, std::filesystem::path>
      folders_;  // of programs in pocl_folder_, by the hash of source and options
};

}  // namespace morphcl
