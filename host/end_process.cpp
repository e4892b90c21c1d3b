#include "host/end_process.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <csignal>

#include "host/leftovers.hpp"

namespace morphcl {

namespace {

std::atomic<bool> thread_at_work{false};

extern "C" void hang(int) {
  for (;;) pause();
}

}  // namespace

void end_process(int code) {
  std::signal(SIGABRT, hang);
  if (const int null = open("/dev/null", O_WRONLY | O_CLOEXEC); null >= 0) dup2(null, STDERR_FILENO);
  remove_leftovers();
  _exit(code);
}

void leave_thread_at_work() { thread_at_work = true; }
bool thread_left_at_work() { return thread_at_work; }

}  // namespace morphcl
