// The bar that a terminal shows while a job runs: done/total, frames per second, time left. Nothing is drawn when
// stderr is no terminal.
#pragma once

#include <chrono>
#include <cstddef>
#include <string_view>

namespace morphcl::cli {

class ProgressBar {
 public:
  ProgressBar(std::size_t total, bool visible);
  ~ProgressBar() { close(); }
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  // `written`: the frame is new. A frame that was only kept moves the bar but does not count for the speed.
  void advance(bool written);
  void message(std::string_view line);  // one line on stderr above the bar
  void close();                         // empties the line; the bar is not drawn any more

  std::size_t done() const { return done_; }
  double frames_per_second() const;  // of written frames, since the bar was made; 0 before the first
  double seconds_left() const;       // 0 before the first written frame

 private:
  void draw() const;
  void erase() const;

  std::size_t total_, done_ = 0, written_ = 0;
  bool visible_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace morphcl::cli
