#include "cli/progress_bar.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdio>
#include <utility>

#include "cli/console.hpp"
#include "host/threads.hpp"

namespace morphcl::cli {

namespace {
constexpr std::chrono::milliseconds shortest_pause{40}, longest_pause{200};  // between two draws
}

ProgressBar::ProgressBar(std::size_t total, Work work, bool visible)
    : total_(total),
      work_(std::move(work)),
      visible_(visible && total > 0 && stderr_is_terminal()),
      speed_start_(Clock::now()) {
  if (!visible_) return;
  draw();
  std::vector<std::jthread> threads;
  start_threads(threads, 1, [this](const std::stop_token& stop, int) { keep_drawing(stop); });
  const std::lock_guard lock(mutex_);
  threads_.swap(threads);
}

void ProgressBar::close() {
  std::vector<std::jthread> threads;
  {
    const std::lock_guard lock(mutex_);
    erase();
    visible_ = false;
    threads.swap(threads_);
  }
  threads.clear();  // each is asked to stop and waited for
}

void ProgressBar::checked() {
  const std::lock_guard lock(mutex_);
  ++checked_;
  if (checked_ == total_) speed_start_ = Clock::now();
  draw_soon();
}

void ProgressBar::drawn() {
  const std::lock_guard lock(mutex_);
  if (std::exchange(any_drawn_, true)) return;
  draw();
}

void ProgressBar::advance(bool written) {
  const std::lock_guard lock(mutex_);
  ++done_;
  if (written && ++written_ == 1 && done_ < total_) {
    // What came before, such as compiling, says nothing about the frames to come.
    speed_start_ = Clock::now();
    written_at_start_ = 1;
  }
  draw_soon();
}

void ProgressBar::message(std::string_view line) {
  const std::lock_guard lock(mutex_);
  erase();
  print_message(line);
  draw();
}

ProgressState ProgressBar::state() const {
  const std::lock_guard lock(mutex_);
  return state_now();
}

std::size_t ProgressBar::done() const {
  const std::lock_guard lock(mutex_);
  return done_;
}

ProgressState ProgressBar::state_now() const {
  ProgressState state;
  state.total = total_;
  if (work_.checks_first && checked_ < total_ && !any_drawn_) {
    state.phase = ProgressState::Phase::checking;
    state.done = checked_;
    return state;
  }
  state.done = done_;
  if (!any_drawn_ && work_.kernels_compiled) state.kernels = work_.kernels_compiled();
  if (state.kernels > 0) state.phase = ProgressState::Phase::compiling;
  const std::chrono::duration<double> elapsed = Clock::now() - speed_start_;
  if (written_ > written_at_start_ && elapsed.count() > 0)
    state.frames_per_second = static_cast<double>(written_ - written_at_start_) / elapsed.count();
  if (state.frames_per_second > 0)
    state.seconds_left = static_cast<double>(total_ - std::min(done_, total_)) / state.frames_per_second;
  return state;
}

void ProgressBar::draw_soon() {
  if (visible_ && (done_ == total_ || Clock::now() - last_draw_ >= shortest_pause)) draw();
}

void ProgressBar::draw() {
  if (!visible_) return;
  last_draw_ = Clock::now();
  fmt::print(stderr, "\r{}\033[K", progress_line(state_now(), terminal_columns(), colors_wanted()));
  std::fflush(stderr);
}

void ProgressBar::erase() const {
  if (!visible_) return;
  fmt::print(stderr, "\r\033[K");
  std::fflush(stderr);
}

void ProgressBar::keep_drawing(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  while (!closed_.wait_for(lock, stop, longest_pause, [&stop] { return stop.stop_requested(); })) draw();
}

}  // namespace morphcl::cli
