// Runs the built `morphcl`.
#pragma once

#include <string>
#include <vector>

#include "tests/support/child_process.hpp"

namespace morphcl::cli_test {

using ToolOptions = test_support::ProcessOptions;
using ToolResult = test_support::ProcessResult;

inline std::vector<std::string> tool_command(const std::vector<std::string>& arguments) {
  std::vector<std::string> command = {MORPHCL_TOOL};
  command.insert(command.end(), arguments.begin(), arguments.end());
  return command;
}

inline ToolResult run_tool(const std::vector<std::string>& arguments, const ToolOptions& options = {}) {
  return test_support::run_process(tool_command(arguments), options);
}

}  // namespace morphcl::cli_test
