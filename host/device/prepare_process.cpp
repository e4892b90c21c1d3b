#include "host/device/prepare_process.hpp"

#include <fmt/format.h>

#include <atomic>
#include <cstdlib>
#include <string>

#include "host/device/probe.hpp"
#include "host/device/thread_count.hpp"
#include "morphcl/session.hpp"

namespace morphcl {

namespace {

std::atomic<bool> prepared = false;

// Two names: PoCL reads the first up to 3.1 and the second from 4.0 on.
constexpr const char* pocl_thread_variables[] = {"POCL_MAX_PTHREAD_COUNT", "POCL_CPU_MAX_CU_COUNT"};

}  // namespace

int prepare_process(int threads) {
  const int count = choose_thread_count(threads);
  // What the user told PoCL himself stands, unless he told morphcl as well.
  const bool overwrite = threads > 0;
  for (const char* variable : pocl_thread_variables) setenv(variable, std::to_string(count).c_str(), overwrite);
  prepared = true;
  probe_installation();
  return count;
}

void ensure_process_prepared(int threads) {
  if (!prepared) prepare_process(threads);
}

Error no_usable_device(std::string_view reason) {
  return Error(ErrorKind::no_device, "",
               fmt::format("no usable OpenCL device: {}; install the package pocl-opencl-icd and mount /sys, or use "
                           "--device reference",
                           reason));
}

}  // namespace morphcl
