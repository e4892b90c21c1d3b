#include "tests/device/child_process.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <sstream>
#include <stdexcept>

namespace morphcl::testing {

namespace {

std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> result;
  for (std::string& text : texts) result.push_back(text.data());
  result.push_back(nullptr);
  return result;
}

std::vector<std::string> variables(Environment environment) {
  for (const char* name : {"PATH", "HOME", "TMPDIR"})
    if (const char* value = std::getenv(name)) environment.emplace(name, value);
  std::vector<std::string> result;
  for (const auto& [name, value] : environment) result.push_back(name + "=" + value);
  return result;
}

}  // namespace

std::string ChildResult::value(const std::string& name) const {
  std::istringstream lines(output);
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with(name + " ")) return line.substr(name.size() + 1);
  return "";
}

ChildProcess::ChildProcess(const std::vector<std::string>& command, const Environment& environment) {
  std::vector<std::string> arguments = command, settings = variables(environment);
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, ends[1], STDERR_FILENO);
  const int failure = posix_spawnp(&pid_, arguments[0].c_str(), &actions, nullptr, pointers(arguments).data(),
                                   pointers(settings).data());
  posix_spawn_file_actions_destroy(&actions);
  close(ends[1]);
  output_ = ends[0];
  if (failure != 0) throw std::runtime_error("cannot start " + arguments[0]);
}

ChildResult ChildProcess::wait() {
  ChildResult result;
  char piece[4096];
  for (ssize_t got; (got = read(output_, piece, sizeof piece)) != 0;) {
    if (got < 0 && errno != EINTR) break;
    if (got > 0) result.output.append(piece, static_cast<std::size_t>(got));
  }
  close(output_);
  int status = 0;
  while (waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
  }
  result.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return result;
}

std::vector<std::string> device_child_command(const std::vector<std::string>& arguments) {
  std::vector<std::string> command = {MORPHCL_DEVICE_CHILD};
  command.insert(command.end(), arguments.begin(), arguments.end());
  return command;
}

Environment warm_cache() {
  const char* folder = std::getenv("MORPHCL_CACHE_DIR");
  return {{"MORPHCL_CACHE_DIR", folder ? folder : "-"}};
}

ChildResult run_device_child(const std::vector<std::string>& arguments, const Environment& environment) {
  return ChildProcess(device_child_command(arguments), environment).wait();
}

}  // namespace morphcl::testing
