#include "cli/stop_signals.hpp"

#include <signal.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <initializer_list>
#include <mutex>
#include <optional>
#include <system_error>
#include <thread>
#include <utility>

#include "cli/console.hpp"
#include "cli/exit_code.hpp"
#include "host/end_process.hpp"
#include "morphcl/error.hpp"

namespace morphcl::cli {

namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds patience{1500}, look_again{50};

std::atomic<bool> stop_asked{false};
static_assert(std::atomic<bool>::is_always_lock_free, "the flag is set inside a signal handler");

struct CurrentPlan {
  std::mutex mutex;
  StopPlan plan{{}, [] { return std::string("interrupted"); }};
};

// Never destroyed: the thread that reads it lives until the process ends.
CurrentPlan& current_plan() {
  static CurrentPlan& current = *new CurrentPlan;
  return current;
}

// Where no thread can be started to wait for signals: without the end after some patience, and with what a second
// signal leaves.
extern "C" void ask_to_stop(int signal_number) {
  if (stop_asked.exchange(true)) _exit(128 + signal_number);
}

// By which the thread that called abort() hands over to the one that waits for signals.
int abort_notice() { return SIGRTMIN + 5; }

std::atomic<bool> watching{false};

extern "C" void hand_over_abort(int) {
  constexpr char words[] = "morphcl: ended by abort()\n";
  if (!watching || kill(getpid(), abort_notice()) != 0) {
    const ssize_t written = write(STDERR_FILENO, words, sizeof words - 1);
    _exit(written < 0 ? static_cast<int>(ErrorKind::internal) : static_cast<int>(ErrorKind::no_device));
  }
  for (;;) pause();
}

sigset_t stop_signals() {
  sigset_t set;
  sigemptyset(&set);
  for (const int number : {SIGTERM, SIGINT, SIGUSR1}) sigaddset(&set, number);
  struct sigaction hang_up = {};
  sigaction(SIGHUP, nullptr, &hang_up);
  if (hang_up.sa_handler != SIG_IGN) sigaddset(&set, SIGHUP);
  return set;
}

void install_handlers(const sigset_t& set) {
  struct sigaction action = {};
  action.sa_handler = ask_to_stop;
  action.sa_flags = SA_RESTART;
  sigemptyset(&action.sa_mask);
  for (const int number : {SIGTERM, SIGINT, SIGUSR1, SIGHUP})
    if (sigismember(&set, number) == 1) sigaction(number, &action, nullptr);
  for (const int number : {SIGPIPE, SIGXFSZ}) signal(number, SIG_IGN);
}

[[noreturn]] void end_after_abort() {
  print_message(
      "ended by abort(), which the OpenCL driver calls where it cannot write or start what it needs; what it says "
      "stands above; `--device reference` needs no driver");
  end_process(static_cast<int>(ErrorKind::no_device));
}

// The signal that came, or none when the time has passed.
std::optional<int> next_signal(const sigset_t& set, Clock::duration limit) {
  const auto nanoseconds = std::chrono::duration_cast<std::chrono::nanoseconds>(limit).count();
  const timespec time = {nanoseconds / 1'000'000'000, nanoseconds % 1'000'000'000};
  const int number = sigtimedwait(&set, nullptr, &time);
  if (number == abort_notice()) end_after_abort();
  return number > 0 ? std::optional(number) : std::nullopt;
}

void end_unless_work_would_be_lost() {
  CurrentPlan& current = current_plan();
  const std::lock_guard lock(current.mutex);
  const StopPlan& plan = current.plan;
  if (plan.may_end && !plan.may_end()) return;
  if (plan.words) print_message(plan.words());
  end_process(exit_interrupted);
}

[[noreturn]] void wait_for_signals(const sigset_t& set) {
  int number = 0;
  while (sigwait(&set, &number) != 0) {
  }
  if (number == abort_notice()) end_after_abort();
  stop_asked = true;
  for (const auto end = Clock::now() + patience;;) {
    const auto left = end - Clock::now();
    if (const auto second = next_signal(set, left > look_again ? left : look_again)) end_process(128 + *second);
    if (Clock::now() >= end) end_unless_work_would_be_lost();
  }
}

}  // namespace

void watch_stop_signals() {
  const sigset_t set = stop_signals();
  install_handlers(set);
  sigset_t waited = set;
  sigaddset(&waited, abort_notice());
  sigset_t blocked = waited;
  for (const int number : {SIGPIPE, SIGXFSZ}) sigaddset(&blocked, number);
  pthread_sigmask(SIG_BLOCK, &blocked, nullptr);
  try {
    std::thread(wait_for_signals, waited).detach();
    watching = true;
  } catch (const std::system_error&) {
    pthread_sigmask(SIG_UNBLOCK, &set, nullptr);
  }
}

void watch_driver_aborts() { signal(SIGABRT, hand_over_abort); }

const std::atomic<bool>& stop_requested() { return stop_asked; }

StopPlanScope::StopPlanScope(StopPlan plan) {
  CurrentPlan& current = current_plan();
  const std::lock_guard lock(current.mutex);
  current.plan = std::move(plan);
}

StopPlanScope::~StopPlanScope() {
  CurrentPlan& current = current_plan();
  const std::lock_guard lock(current.mutex);
  current.plan = {};
}

}  // namespace morphcl::cli
