#include "tests/cli/tool_process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <sstream>
#include <stdexcept>
#include <thread>

extern char** environ;

namespace morphcl::cli_test {

namespace fs = std::filesystem;

namespace {
constexpr auto poll_interval = std::chrono::milliseconds(2);

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::vector<std::string> environment_with(const std::map<std::string, std::string>& changes) {
  std::map<std::string, std::string> all;
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string text = *entry;
    const std::size_t equals = text.find('=');
    if (equals != std::string::npos) all[text.substr(0, equals)] = text.substr(equals + 1);
  }
  for (const auto& [name, value] : changes) all[name] = value;
  std::vector<std::string> list;
  for (const auto& [name, value] : all) list.push_back(name + "=" + value);
  return list;
}

std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> list;
  for (std::string& text : texts) list.push_back(text.data());
  list.push_back(nullptr);
  return list;
}

fs::path new_file() {
  std::string name = (fs::temp_directory_path() / "morphcl-tool-XXXXXX").string();
  const int descriptor = mkstemp(name.data());
  if (descriptor < 0) throw std::runtime_error("no temporary file: " + name);
  close(descriptor);
  return name;
}

int open_terminal() {
  const int terminal = posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
  if (terminal < 0 || grantpt(terminal) != 0 || unlockpt(terminal) != 0) throw std::runtime_error("no pseudo-terminal");
  return terminal;
}
}  // namespace

std::vector<std::string> ToolResult::out_lines() const { return lines_of(out); }
std::vector<std::string> ToolResult::err_lines() const { return lines_of(err); }

ToolProcess::ToolProcess(const std::vector<std::string>& arguments, const ToolOptions& options)
    : options_(options), out_(new_file()), err_(new_file()) {
  std::vector<std::string> words = {MORPHCL_TOOL};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<std::string> variables = environment_with(options.environment);
  std::string err_path = err_.string();
  if (options.stderr_is_terminal) {
    terminal_ = open_terminal();
    err_path = ptsname(terminal_);
  }
  const std::string out_path = options.stdout_path.empty() ? out_.string() : options.stdout_path;

  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, out_path.c_str(), O_WRONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, err_path.c_str(), O_WRONLY | O_NOCTTY, 0);
  if (!options.folder.empty()) posix_spawn_file_actions_addchdir_np(&actions, options.folder.c_str());
  const int failure =
      posix_spawn(&pid_, words[0].c_str(), &actions, nullptr, pointers(words).data(), pointers(variables).data());
  posix_spawn_file_actions_destroy(&actions);
  if (failure != 0) throw std::runtime_error("cannot start " + words[0]);
}

ToolProcess::~ToolProcess() {
  if (pid_ > 0) {
    kill(pid_, SIGKILL);
    waitpid(pid_, nullptr, 0);
  }
  if (terminal_ >= 0) close(terminal_);
  fs::remove(out_);
  fs::remove(err_);
}

void ToolProcess::signal(int number) const { kill(pid_, number); }

bool ToolProcess::wait_until_it_handles(int number) const {
  const auto end = std::chrono::steady_clock::now() + options_.limit;
  while (std::chrono::steady_clock::now() < end) {
    std::ifstream status("/proc/" + std::to_string(pid_) + "/status");
    for (std::string line; std::getline(status, line);)
      if (line.rfind("SigCgt:", 0) == 0 && (std::stoull(line.substr(7), nullptr, 16) >> (number - 1) & 1) != 0)
        return true;
    siginfo_t ended = {};
    if (waitid(P_PID, static_cast<id_t>(pid_), &ended, WEXITED | WNOHANG | WNOWAIT) == 0 && ended.si_pid != 0)
      return false;
    std::this_thread::sleep_for(poll_interval);
  }
  return false;
}

ToolResult ToolProcess::wait() {
  ToolResult result;
  const auto end = std::chrono::steady_clock::now() + options_.limit;
  int status = 0;
  while (waitpid(pid_, &status, WNOHANG) == 0) {
    if (!result.timed_out && std::chrono::steady_clock::now() > end) {
      result.timed_out = true;
      kill(pid_, SIGKILL);
    }
    drain_terminal();
    std::this_thread::sleep_for(poll_interval);
  }
  pid_ = -1;
  drain_terminal();
  result.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  result.out = read_and_remove(out_);
  result.err = read_and_remove(err_) + terminal_text_;
  return result;
}

void ToolProcess::drain_terminal() {
  if (terminal_ < 0) return;
  pollfd ready = {terminal_, POLLIN, 0};
  char bytes[4096];
  while (poll(&ready, 1, 0) == 1 && (ready.revents & POLLIN) != 0) {
    const ssize_t count = read(terminal_, bytes, sizeof bytes);
    if (count <= 0) return;
    terminal_text_.append(bytes, static_cast<std::size_t>(count));
  }
}

std::string ToolProcess::read_and_remove(const fs::path& file) const {
  std::ifstream stream(file, std::ios::binary);
  std::string text(std::istreambuf_iterator<char>(stream), {});
  fs::remove(file);
  return text;
}

ToolResult run_tool(const std::vector<std::string>& arguments, const ToolOptions& options) {
  return ToolProcess(arguments, options).wait();
}

}  // namespace morphcl::cli_test
