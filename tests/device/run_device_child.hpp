// Runs the program device_child under a given environment.
#pragma once

#include <string>
#include <vector>

#include "tests/support/child_process.hpp"

namespace morphcl::testing {

struct ChildResult {
  int exit_code = -1;  // 128 + signal if it was stopped by one
  std::string output;  // stdout and stderr

  // The rest of the first line that starts with `name` and a space; "" if there is none.
  std::string value(const std::string& name) const;
};

// What a child that opens a device is given: of this process's variables it sees PATH, HOME and TMPDIR only, so that
// what the test names is all that decides.
test_support::ProcessOptions device_options(const test_support::Environment& environment);

ChildResult result_of(test_support::ChildProcess& child);
ChildResult run_child(const std::vector<std::string>& command, const test_support::Environment& environment);

// device_child with these arguments, to its end.
ChildResult run_device_child(const std::vector<std::string>& arguments, const test_support::Environment& environment);

std::vector<std::string> device_child_command(const std::vector<std::string>& arguments);

}  // namespace morphcl::testing
