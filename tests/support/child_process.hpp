// A program that runs beside the test, and ends with it.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace morphcl::test_support {

// Variables that replace or join those of this process; without a value they are taken out.
using Environment = std::map<std::string, std::optional<std::string>>;

// Where the child's stderr goes.
enum class StandardError {
  apart,        // kept by itself
  with_stdout,  // to where stdout goes, in the order in which both are written
  terminal,     // to a pseudo-terminal, and kept by itself
};

struct ProcessOptions {
  Environment environment = {};
  bool inherits_environment = true;      // false: of this process's variables only PATH, HOME and TMPDIR
  std::filesystem::path folder = {};     // working folder; empty: this process's
  std::filesystem::path stdout_to = {};  // a file that exists; empty: stdout is kept
  StandardError standard_error = StandardError::apart;
  unsigned short terminal_columns = 0;  // of the pseudo-terminal; 0: it does not say
  std::chrono::seconds limit{120};      // of finish() and wait_until_it_handles()
};

struct ProcessResult {
  int code = -1;           // exit code; 128 + signal when a signal ended it
  bool timed_out = false;  // it was killed after the limit
  std::string out, err;    // stdout, stderr

  std::vector<std::string> out_lines() const;
  std::vector<std::string> err_lines() const;
};

class ChildProcess {
 public:
  // Looks for `command[0]` in PATH where it holds no slash. stdin is empty. Throws std::runtime_error when the program
  // cannot be started.
  explicit ChildProcess(const std::vector<std::string>& command, ProcessOptions options = {});
  ~ChildProcess();  // ends what still runs: by TERM, so that it can clean up, and if it does not obey by KILL
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  pid_t pid() const { return pid_; }
  void signal(int number);  // nothing where it has ended

  // Returns once the process has its own handler for this signal; false when it ended before or the limit passed.
  bool wait_until_it_handles(int number);

  // The exit code (128 + signal when a signal ended it), or none when it still runs after `limit`.
  std::optional<int> wait(std::chrono::seconds limit);
  bool runs() { return !wait(std::chrono::seconds(0)).has_value(); }

  // Waits for the end, by KILL after the limit.
  ProcessResult finish();

  std::string out() const;  // so far
  std::string err();

 private:
  void start(const std::vector<std::string>& command);
  void drain_terminal();

  ProcessOptions options_;
  pid_t pid_ = -1;
  int out_ = -1, err_ = -1, terminal_ = -1;
  std::string terminal_text_;
  std::optional<int> exit_code_;
};

ProcessResult run_process(const std::vector<std::string>& command, const ProcessOptions& options = {});

std::vector<std::string> lines_of(const std::string& text);

}  // namespace morphcl::test_support
