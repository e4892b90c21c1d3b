#include "tests/demos/program_process.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <stdexcept>
#include <thread>

namespace morphcl::viewer_test {
namespace {

constexpr std::chrono::seconds kTermLimit{10};

int unnamed_file(const std::filesystem::path& folder) {
  std::string name = (folder / "output-XXXXXX").string();
  const int file = mkostemp(name.data(), O_CLOEXEC);
  if (file < 0) throw std::runtime_error("cannot create " + name);
  unlink(name.c_str());
  return file;
}

std::string content(int file) {
  std::string text;
  char buffer[4096];
  for (ssize_t got = 0; (got = pread(file, buffer, sizeof buffer, static_cast<off_t>(text.size()))) > 0;) {
    text.append(buffer, static_cast<std::size_t>(got));
  }
  return text;
}

}  // namespace

ProgramProcess::ProgramProcess(const std::vector<std::string>& command, const std::filesystem::path& folder,
                               const Environment& environment)
    : out_(unnamed_file(folder)), err_(unnamed_file(folder)) {
  std::vector<char*> arguments;
  for (const std::string& argument : command) arguments.push_back(const_cast<char*>(argument.c_str()));
  arguments.push_back(nullptr);
  pid_ = fork();
  if (pid_ < 0) throw std::runtime_error("cannot fork");
  if (pid_ == 0) {
    for (const auto& [name, value] : environment) {
      if (value.empty()) {
        unsetenv(name.c_str());
      } else {
        setenv(name.c_str(), value.c_str(), 1);
      }
    }
    if (chdir(folder.c_str()) != 0 || dup2(out_, STDOUT_FILENO) < 0 || dup2(err_, STDERR_FILENO) < 0) _exit(126);
    execvp(arguments[0], arguments.data());
    _exit(127);
  }
}

ProgramProcess::~ProgramProcess() {
  if (runs()) kill(pid_, SIGTERM);
  if (!wait(kTermLimit)) {
    kill(pid_, SIGKILL);
    waitpid(pid_, nullptr, 0);
  }
  close(out_);
  close(err_);
}

std::optional<int> ProgramProcess::wait(std::chrono::seconds limit) {
  const auto end = std::chrono::steady_clock::now() + limit;
  while (!exit_code_) {
    int status = 0;
    if (waitpid(pid_, &status, WNOHANG) == pid_) {
      exit_code_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    } else if (std::chrono::steady_clock::now() >= end) {
      break;
    } else {
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
  }
  return exit_code_;
}

std::string ProgramProcess::out() const { return content(out_); }

std::string ProgramProcess::err() const { return content(err_); }

}  // namespace morphcl::viewer_test
