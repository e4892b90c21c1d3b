// Runs the program device_child under a given environment.
#pragma once

#include <sys/types.h>

#include <map>
#include <string>
#include <vector>

namespace morphcl::testing {

struct ChildResult {
  int exit_code = -1;  // 128 + signal if it was stopped by one
  std::string output;  // stdout and stderr

  // The rest of the first line that starts with `name` and a space; "" if there is none.
  std::string value(const std::string& name) const;
};

// Variables that the child sees beside PATH, HOME and TMPDIR; nothing else of this process's environment is passed on.
using Environment = std::map<std::string, std::string>;

// A child under way; wait() must be called once.
class ChildProcess {
 public:
  ChildProcess(const std::vector<std::string>& command, const Environment& environment);
  ChildResult wait();

 private:
  pid_t pid_;
  int output_;
};

// device_child with these arguments, to its end.
ChildResult run_device_child(const std::vector<std::string>& arguments, const Environment& environment);

std::vector<std::string> device_child_command(const std::vector<std::string>& arguments);

// The kernel cache of this process for a child that need not start cold, or none.
Environment warm_cache();

}  // namespace morphcl::testing
