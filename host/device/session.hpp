// An open OpenCL device: context, queue, self-test verdict, and the programs built for it.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "host/device/kernel.hpp"
#include "host/device/opencl.hpp"

namespace morphcl {

enum class Verdict { identical, tolerant };

struct DeviceInfo {
  int index = 0;  // position in the list that `morphcl devices` prints; usable as --device
  std::string name, vendor, driver_version, platform;
  bool is_cpu = false;
  unsigned compute_units = 0;
  std::size_t global_memory = 0, max_allocation = 0, local_memory = 0;
  bool fp64 = false;
};

struct SessionOptions {
  std::string device;     // "" the first CPU device, else the first of any kind; a number: index; else part of a name
  int threads = 0;        // 0: SLURM_CPUS_PER_TASK, else the affinity mask
  std::string cache_dir;  // "" $MORPHCL_CACHE_DIR, else $XDG_CACHE_HOME/morphcl, else ~/.cache/morphcl; "-" no cache
  // Changes each kernel program's text before it is built; for tests that break a kernel on purpose.
  std::function<std::string(const std::string&)> edit_source;
};

// Must run before the process's first OpenCL call: sets PoCL's thread variables from `threads`, then probes the
// installation in a child process, because PoCL 3.1 aborts where /sys is not mounted. Returns the thread count.
int prepare_process(int threads);

// Error(no_device) with the package to install when there is none.
std::vector<DeviceInfo> list_devices();

class Session {
 public:
  // Error(no_device): none found, or none matches; the message lists what there is.
  static std::shared_ptr<Session> open(const SessionOptions& options);
  ~Session();

  const DeviceInfo& info() const;
  // Result of the self-test (+ - * / sqrt fma, denormals, -0, half conversion, against the host, bit for bit).
  Verdict verdict() const;
  const std::string& verdict_detail() const;  // "" or what differs, with the largest difference in ulp

  const cl::Context& context() const;
  const cl::CommandQueue& queue() const;  // in order

  // A kernel of a program that the build embedded, built on first use from the cached binary, else from source.
  // Thread-safe; each call returns a kernel object of its own, so that threads do not share arguments. Errors name the
  // file and hold the first line of the build log. `more_options` (" -DNAME=VALUE") are added to those of every kernel;
  // each choice of them is a program of its own.
  Kernel kernel(const KernelSource& source, const std::string& kernel_name, const std::string& more_options = "");

  // Stores the binaries of programs that were built from source, for the kernels taken from them so far. These must
  // have run by now: binaries hold work-group functions. Call it after the first frame is written, or from a thread of
  // its own, as kernels may be used meanwhile: PoCL takes about as long as it took to compile. Call it again at the
  // end, for kernels that later frames brought in; it is cheap when there is nothing to store. Never throws: an
  // unwritable cache is no error.
  void store_programs();

 private:
  Session();
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace morphcl
