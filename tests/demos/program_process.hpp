// A program that runs beside the test, and ends with it.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace morphcl::viewer_test {

using Environment = std::map<std::string, std::string>;  // added to or replacing this process's; empty value: taken out

class ProgramProcess {
 public:
  // Looks for `command[0]` in PATH where it holds no slash. Runs in `folder`; stdout and stderr go to files that have
  // no name there.
  ProgramProcess(const std::vector<std::string>& command, const std::filesystem::path& folder,
                 const Environment& environment);
  ~ProgramProcess();  // ends what still runs: by TERM, so that it can clean up, and if it does not obey by KILL
  ProgramProcess(const ProgramProcess&) = delete;
  ProgramProcess& operator=(const ProgramProcess&) = delete;

  pid_t pid() const { return pid_; }

  // The exit code (128 + signal when a signal ended it), or none when it still runs after `limit`.
  std::optional<int> wait(std::chrono::seconds limit);
  bool runs() { return !wait(std::chrono::seconds(0)).has_value(); }

  std::string out() const;  // so far
  std::string err() const;

 private:
  pid_t pid_ = -1;
  int out_ = -1, err_ = -1;
  std::optional<int> exit_code_;
};

}  // namespace morphcl::viewer_test
