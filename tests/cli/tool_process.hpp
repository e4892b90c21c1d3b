// Runs the built `morphcl` and keeps what it printed.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace morphcl::cli_test {

struct ToolResult {
  int code = -1;           // exit code; 128 + signal when a signal ended it
  bool timed_out = false;  // it was killed after the time limit
  std::string out, err;    // stdout, stderr
  std::vector<std::string> out_lines() const;
  std::vector<std::string> err_lines() const;
};

struct ToolOptions {
  std::map<std::string, std::string> environment = {};  // replaces or adds variables
  std::filesystem::path folder = {};                    // working folder
  std::string stdout_path = {};                         // "" kept in ToolResult::out
  bool stderr_is_terminal = false;                      // stderr is a pseudo-terminal
  std::chrono::seconds limit{120};
};

class ToolProcess {
 public:
  ToolProcess(const std::vector<std::string>& arguments, const ToolOptions& options);
  ~ToolProcess();  // kills what still runs
  ToolProcess(const ToolProcess&) = delete;
  ToolProcess& operator=(const ToolProcess&) = delete;

  void signal(int number) const;
  // Returns once the process has its own handler for this signal; false when it ended before or the limit passed.
  bool wait_until_it_handles(int number) const;
  ToolResult wait();

 private:
  std::string read_and_remove(const std::filesystem::path& file) const;
  void drain_terminal();

  ToolOptions options_;
  std::filesystem::path out_, err_;
  std::string terminal_text_;
  int terminal_ = -1;
  pid_t pid_ = -1;
};

ToolResult run_tool(const std::vector<std::string>& arguments, const ToolOptions& options = {});

}  // namespace morphcl::cli_test
