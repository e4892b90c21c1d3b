#include "cli/stop_signals.hpp"

#include <signal.h>
#include <unistd.h>

#include <initializer_list>

namespace morphcl::cli {

namespace {
std::atomic<bool> stop_asked{false};
static_assert(std::atomic<bool>::is_always_lock_free, "the flag is set inside a signal handler");

extern "C" void ask_to_stop(int signal_number) {
  if (stop_asked.exchange(true)) _exit(128 + signal_number);
}

bool install() {
  struct sigaction action = {};
  action.sa_handler = ask_to_stop;
  action.sa_flags = SA_RESTART;
  sigemptyset(&action.sa_mask);
  for (int number : {SIGTERM, SIGINT, SIGUSR1}) sigaction(number, &action, nullptr);
  for (int number : {SIGPIPE, SIGXFSZ}) signal(number, SIG_IGN);
  return true;
}
}  // namespace

const std::atomic<bool>& stop_requested() {
  static const bool installed = install();
  static_cast<void>(installed);
  return stop_asked;
}

}  // namespace morphcl::cli
