// An action whose end would end the test too, or whose limits would bind it: in a process of its own.
#pragma once

#include <sys/wait.h>
#include <unistd.h>

#include <functional>

#include "morphcl/error.hpp"

namespace morphcl::test_support {

// 0, or the exit code of the Error that it threw, or 128 and the number of the signal that ended it.
inline int exit_code_of(const std::function<void()>& action) {
  const pid_t pid = fork();
  if (pid == 0) {
    try {
      action();
    } catch (const Error& error) {
      _exit(error.exit_code());
    }
    _exit(0);
  }
  int status = -1;
  waitpid(pid, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace morphcl::test_support
