// An open OpenCL device. Nothing of OpenCL shows here: opencl_interop.hpp gives access to context and queue.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#pragma GCC visibility push(default)
namespace morphcl {

// What the self-test of a device says: identical, it computes the bits that every other such device computes; tolerant,
// it rounds differently somewhere, by 4 ulp at most. A device that is further off is not opened.
enum class Verdict { identical, tolerant };

struct DeviceInfo {
  int index = 0;  // place in the list that `morphcl devices` prints; usable as --device
  std::string name, vendor, driver_version, platform;
  bool is_cpu = false;
  unsigned compute_units = 0;
  std::size_t global_memory = 0, max_allocation = 0, local_memory = 0;  // bytes
  bool fp64 = false;                                                    // computes in double
};

struct SessionOptions {
  std::string device;  // "" the first CPU device, else the first of any kind; a number: index; else part of a name
  // 1 to 4096, of the process's first session alone (PoCL's threads); 0: SLURM_CPUS_PER_TASK, else the affinity mask.
  int threads = 0;
  // "" $MORPHCL_CACHE_DIR, else $XDG_CACHE_HOME/morphcl, else ~/.cache/morphcl; "-" no cache. So in the variable too.
  std::string cache_dir;
};

// For programs that call OpenCL themselves before list_devices() or Session::open(), which call it otherwise: it sets
// PoCL's thread variables from `threads`, then tests in a child process that asking for devices does not abort, as PoCL
// 3.1 does where /sys is not mounted. Returns the thread count, which is smaller than asked for where the system starts
// no more. Error(usage) for threads outside of 0 to 4096, and for numbers in PoCL's own variables that it crashes on;
// Error(no_device) where not one thread can be started, or a limit of the process (stack, file size) is below what the
// driver needs.
int prepare_process(int threads);

// In the order of DeviceInfo::index. Error(no_device) with the package to install when there is none.
std::vector<DeviceInfo> list_devices();

// Threads may share a session. Who takes one, as a renderer does, shares its ownership.
class Session {
 public:
  // Error(no_device): none found, none matches, and then the message lists what there is, or the device fails the
  // self-test by more than 4 ulp. Error(usage) for `threads`.
  static std::shared_ptr<Session> open(const SessionOptions& options);
  ~Session();

  const DeviceInfo& info() const;
  // Result of the self-test (+ - * / sqrt fma, denormals, -0, half conversion, against the host, bit for bit).
  Verdict verdict() const;
  const std::string& verdict_detail() const;  // "" or what differs, with the largest difference in ulp

  // Stores what was compiled in this session and has run, for later processes. Call it after the first frame is
  // written, and again at the end, for what later frames brought in. Takes milliseconds with PoCL; where POCL_CACHE_DIR
  // is set about as long as compiling took. Never throws: an unwritable cache is no error.
  void store_programs();

  // So far: those that were not found in the cache. Each is compiled when it runs for the first time, which takes PoCL
  // a second or so. For any thread; never waits for the compiler.
  std::size_t kernels_compiled() const;

  // "", or why store_programs() could not store what was compiled, so that the next process compiles it anew: one line.
  // "" also where no cache is wanted.
  std::string cache_trouble() const;

 private:
  friend struct SessionAccess;
  Session();
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace morphcl
#pragma GCC visibility pop
