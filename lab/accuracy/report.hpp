// The report: every operation that was asked for, and on what it was measured.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "lab/accuracy/operation.hpp"

namespace morphcl::accuracy {

struct Machine {
  std::string processor, compiler, host_flags;
  std::string device, driver, platform, verdict, device_flags;  // empty where none was used
  int threads = 0;                                              // of the device
};

struct Report {
  Machine machine;
  Settings settings;
  std::vector<OperationReport> operations;

  bool digits_confirmed() const;
};

// Names of all operations. run_report() throws Error(usage) that lists them when it is asked for another.
std::vector<std::string> operation_names();

// Runs the operations of these names, all when there are none; `progress` is called before each with its name, its
// number and how many there are. Operations follow each other; what they time runs on one thread of the host.
Report run_report(const Settings& settings, const std::vector<std::string>& names, int threads,
                  const std::function<void(const std::string&, std::size_t, std::size_t)>& progress);

}  // namespace morphcl::accuracy
