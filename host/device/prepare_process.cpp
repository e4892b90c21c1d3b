#include "host/device/prepare_process.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <string>

#include "host/device/driver_needs.hpp"
#include "host/device/probe.hpp"
#include "host/thread_count.hpp"
#include "morphcl/session.hpp"

namespace morphcl {

namespace {

std::atomic<bool> prepared = false;

// Of PoCL, by what stands in the environment.
int driver_threads(int count) {
  for (const char* variable : pocl_thread_variables)
    if (const char* value = std::getenv(variable)) count = std::max(count, std::atoi(value));
  return count;
}

void set_driver_threads(int count, bool overwrite) {
  for (const char* variable : pocl_thread_variables) setenv(variable, std::to_string(count).c_str(), overwrite);
}

}  // namespace

int prepare_process(int threads) {
  int count = choose_thread_count(threads);
  // What the user told PoCL himself stands, unless he told morphcl as well.
  if (threads == 0) check_driver_variables();
  set_driver_threads(count, threads > 0);
  check_driver_limits();
  const int wanted = driver_threads(count), possible = startable_threads(wanted);
  if (possible < wanted) set_driver_threads(possible, true);
  count = std::min(count, possible);
  prepared = true;
  probe_installation();
  return count;
}

void ensure_process_prepared(int threads) {
  if (!prepared) prepare_process(threads);
}

Error no_usable_device(std::string_view reason, std::string_view remedy) {
  if (remedy.empty()) remedy = "install the package pocl-opencl-icd and mount /sys, or use --device reference";
  return Error(ErrorKind::no_device, "", fmt::format("no usable OpenCL device: {}; {}", reason, remedy));
}

}  // namespace morphcl
