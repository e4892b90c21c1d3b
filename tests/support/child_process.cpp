#include "tests/support/child_process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <stdlib.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <sstream>
#include <stdexcept>
#include <thread>

extern char** environ;

namespace morphcl::test_support {

namespace {

using Clock = std::chrono::steady_clock;

constexpr auto poll_interval = std::chrono::milliseconds(2);
constexpr std::chrono::seconds term_limit{10};

std::vector<std::string> variables(const ProcessOptions& options) {
  Environment all;
  for (char** entry = environ; options.inherits_environment && *entry != nullptr; ++entry) {
    const std::string text = *entry;
    const std::size_t equals = text.find('=');
    if (equals != std::string::npos) all[text.substr(0, equals)] = text.substr(equals + 1);
  }
  for (const char* name : {"PATH", "HOME", "TMPDIR"})
    if (const char* value = getenv(name)) all[name] = value;
  for (const auto& [name, value] : options.environment) all[name] = value;
  std::vector<std::string> list;
  for (const auto& [name, value] : all)
    if (value) list.push_back(name + "=" + *value);
  return list;
}

std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> list;
  for (std::string& text : texts) list.push_back(text.data());
  list.push_back(nullptr);
  return list;
}

// A file in memory, so that no folder of the test has more in it than the child puts there.
int unnamed_file() {
  const int file = memfd_create("output", MFD_CLOEXEC);
  if (file < 0) throw std::runtime_error("no file in memory");
  return file;
}

std::string content(int file) {
  std::string text;
  char bytes[4096];
  for (ssize_t count = 0; (count = pread(file, bytes, sizeof bytes, static_cast<off_t>(text.size()))) > 0;)
    text.append(bytes, static_cast<std::size_t>(count));
  return text;
}

int open_terminal(unsigned short columns) {
  const int terminal = posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
  if (terminal < 0 || grantpt(terminal) != 0 || unlockpt(terminal) != 0) throw std::runtime_error("no pseudo-terminal");
  winsize size{};
  size.ws_col = columns;
  size.ws_row = 24;
  if (columns > 0 && ioctl(terminal, TIOCSWINSZ, &size) != 0)
    throw std::runtime_error("no size of the pseudo-terminal");
  return terminal;
}

}  // namespace

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::vector<std::string> ProcessResult::out_lines() const { return lines_of(out); }
std::vector<std::string> ProcessResult::err_lines() const { return lines_of(err); }

ChildProcess::ChildProcess(const std::vector<std::string>& command, ProcessOptions options)
    : options_(std::move(options)), out_(unnamed_file()), err_(unnamed_file()) {
  start(command);
}

void ChildProcess::start(const std::vector<std::string>& command) {
  std::vector<std::string> words = command, settings = variables(options_);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  if (options_.stdout_to.empty())
    posix_spawn_file_actions_adddup2(&actions, out_, STDOUT_FILENO);
  else
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, options_.stdout_to.c_str(), O_WRONLY, 0);
  std::string terminal_path;
  if (options_.standard_error == StandardError::terminal) {
    terminal_ = open_terminal(options_.terminal_columns);
    terminal_path = ptsname(terminal_);
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, terminal_path.c_str(), O_WRONLY | O_NOCTTY, 0);
  } else {
    const bool together = options_.standard_error == StandardError::with_stdout;
    posix_spawn_file_actions_adddup2(&actions, together ? STDOUT_FILENO : err_, STDERR_FILENO);
  }
  if (!options_.folder.empty()) posix_spawn_file_actions_addchdir_np(&actions, options_.folder.c_str());
  const int failure =
      posix_spawnp(&pid_, words[0].c_str(), &actions, nullptr, pointers(words).data(), pointers(settings).data());
  posix_spawn_file_actions_destroy(&actions);
  if (failure != 0) throw std::runtime_error("cannot start " + words[0]);
}

ChildProcess::~ChildProcess() {
  signal(SIGTERM);
  if (!wait(term_limit)) {
    signal(SIGKILL);
    waitpid(pid_, nullptr, 0);
  }
  if (terminal_ >= 0) close(terminal_);
  close(out_);
  close(err_);
}

void ChildProcess::signal(int number) {
  if (!exit_code_) kill(pid_, number);
}

bool ChildProcess::wait_until_it_handles(int number) {
  const auto end = Clock::now() + options_.limit;
  while (runs() && Clock::now() < end) {
    std::ifstream status("/proc/" + std::to_string(pid_) + "/status");
    for (std::string line; std::getline(status, line);)
      if (line.starts_with("SigCgt:") && (std::stoull(line.substr(7), nullptr, 16) >> (number - 1) & 1) != 0)
        return true;
    std::this_thread::sleep_for(poll_interval);
  }
  return false;
}

std::optional<int> ChildProcess::wait(std::chrono::seconds limit) {
  const auto end = Clock::now() + limit;
  while (!exit_code_) {
    drain_terminal();  // a child stops where the terminal is full
    int status = 0;
    if (waitpid(pid_, &status, WNOHANG) == pid_) {
      exit_code_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
      drain_terminal();
    } else if (Clock::now() >= end) {
      break;
    } else {
      std::this_thread::sleep_for(poll_interval);
    }
  }
  return exit_code_;
}

ProcessResult ChildProcess::finish() {
  ProcessResult result;
  if (!wait(options_.limit)) {
    result.timed_out = true;
    signal(SIGKILL);
  }
  while (!wait(term_limit)) {
  }
  result.code = *exit_code_;
  result.out = out();
  result.err = err();
  return result;
}

std::string ChildProcess::out() const { return content(out_); }

std::string ChildProcess::err() {
  drain_terminal();
  return content(err_) + terminal_text_;
}

void ChildProcess::drain_terminal() {
  if (terminal_ < 0) return;
  pollfd ready = {terminal_, POLLIN, 0};
  char bytes[4096];
  while (poll(&ready, 1, 0) == 1 && (ready.revents & POLLIN) != 0) {
    const ssize_t count = read(terminal_, bytes, sizeof bytes);
    if (count <= 0) return;
    terminal_text_.append(bytes, static_cast<std::size_t>(count));
  }
}

ProcessResult run_process(const std::vector<std::string>& command, const ProcessOptions& options) {
  return ChildProcess(command, options).finish();
}

}  // namespace morphcl::test_support
