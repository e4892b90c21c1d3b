#include "tests/device/run_device_child.hpp"

namespace morphcl::testing {

using test_support::ChildProcess;
using test_support::Environment;
using test_support::ProcessOptions;
using test_support::ProcessResult;

std::string ChildResult::value(const std::string& name) const {
  for (const std::string& line : test_support::lines_of(output))
    if (line.starts_with(name + " ")) return line.substr(name.size() + 1);
  return "";
}

ProcessOptions device_options(const Environment& environment) {
  ProcessOptions options;
  options.environment = environment;
  options.inherits_environment = false;
  options.standard_error = test_support::StandardError::with_stdout;
  options.limit = std::chrono::minutes(20);  // kernels are compiled anew, or interpreted, on a busy machine
  return options;
}

ChildResult result_of(ChildProcess& child) {
  const ProcessResult result = child.finish();
  return {result.code, result.out};
}

ChildResult run_child(const std::vector<std::string>& command, const Environment& environment) {
  ChildProcess child(command, device_options(environment));
  return result_of(child);
}

std::vector<std::string> device_child_command(const std::vector<std::string>& arguments) {
  std::vector<std::string> command = {MORPHCL_DEVICE_CHILD};
  command.insert(command.end(), arguments.begin(), arguments.end());
  return command;
}

ChildResult run_device_child(const std::vector<std::string>& arguments, const Environment& environment) {
  return run_child(device_child_command(arguments), environment);
}

}  // namespace morphcl::testing
