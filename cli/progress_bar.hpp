// The bar that a terminal shows while a job runs: what it does, done/total, frames per second, time left. Nothing is
// drawn when stderr is no terminal.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <functional>
#include <mutex>
#include <string_view>
#include <thread>
#include <vector>

#include "cli/progress_line.hpp"

namespace morphcl::cli {

// For several threads. A visible bar draws itself a few times a second, so that time goes on while a frame does not
// end, and a window that has got another width is filled anew.
class ProgressBar {
 public:
  struct Work {
    bool checks_first = false;                      // checked() comes for each frame before one is drawn
    std::function<std::size_t()> kernels_compiled;  // so far; may be empty
  };
  ProgressBar(std::size_t total, Work work, bool visible);
  ~ProgressBar() { close(); }
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  void checked();  // a frame was looked for
  void drawn();    // a frame is drawn, so what it needed is compiled
  // A frame is done. `written`: it is new. One that was only kept moves the bar but does not count for the speed.
  void advance(bool written);
  void message(std::string_view line);  // one line on stderr above the bar
  void close();                         // empties the line; the bar is not drawn any more

  ProgressState state() const;
  std::size_t done() const;

 private:
  using Clock = std::chrono::steady_clock;

  ProgressState state_now() const;
  void draw_soon();
  void draw();
  void erase() const;
  void keep_drawing(const std::stop_token& stop);

  const std::size_t total_;
  const Work work_;
  mutable std::mutex mutex_;  // for all below
  std::condition_variable_any closed_;
  std::size_t checked_ = 0, done_ = 0, written_ = 0;
  bool any_drawn_ = false, visible_;
  Clock::time_point speed_start_;  // with how many frames were written then
  std::size_t written_at_start_ = 0;
  Clock::time_point last_draw_;
  std::vector<std::jthread> threads_;  // one that draws, or none
};

}  // namespace morphcl::cli
