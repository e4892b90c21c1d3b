#include "cli/progress_bar.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "cli/console.hpp"

namespace morphcl::cli {

namespace {
constexpr std::size_t bar_cells = 30;

std::string clock_text(double seconds) {
  const long whole = std::lround(std::min(seconds, 359'999.0));  // at most 99:59:59
  return whole < 3600 ? fmt::format("{:02}:{:02}", whole / 60, whole % 60)
                      : fmt::format("{:02}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}
}  // namespace

ProgressBar::ProgressBar(std::size_t total, bool visible)
    : total_(total), visible_(visible && total > 0 && stderr_is_terminal()) {
  draw();
}

void ProgressBar::close() {
  erase();
  visible_ = false;
}

void ProgressBar::advance(bool written) {
  ++done_;
  if (written) ++written_;
  draw();
}

void ProgressBar::message(std::string_view line) {
  erase();
  print_message(line);
  draw();
}

double ProgressBar::frames_per_second() const {
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start_;
  return elapsed.count() > 0 ? static_cast<double>(written_) / elapsed.count() : 0.0;
}

double ProgressBar::seconds_left() const {
  const double speed = frames_per_second();
  return speed > 0 ? static_cast<double>(total_ - std::min(done_, total_)) / speed : 0.0;
}

void ProgressBar::draw() const {
  if (!visible_) return;
  const std::size_t full = bar_cells * std::min(done_, total_) / total_;
  std::string bar(full, '#');
  if (colors_wanted()) bar = "\033[32m" + bar + "\033[0m";
  bar += std::string(bar_cells - full, '.');
  fmt::print(stderr, "\r[{}] {}/{} frames  {:.1f} frames/s  {} left\033[K", bar, done_, total_, frames_per_second(),
             clock_text(seconds_left()));
  std::fflush(stderr);
}

void ProgressBar::erase() const {
  if (!visible_) return;
  fmt::print(stderr, "\r\033[K");
  std::fflush(stderr);
}

}  // namespace morphcl::cli
