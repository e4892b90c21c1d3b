#include "demos/viewer/run_window.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <limits>
#include <optional>

#include "demos/viewer/hold_repeat.hpp"
#include "demos/viewer/play_clock.hpp"
#include "demos/viewer/script_player.hpp"
#include "morphcl/error.hpp"

namespace morphcl::viewer {
namespace {

constexpr int kLargestSide = 16384;  // pixels of a frame (morphcl/scene.hpp)

double now_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

class WindowLoop {
 public:
  WindowLoop(Window& window, DemoSession& session, const std::vector<KeyPress>& script, double frames_per_second,
             double ticks_per_second)
      : window_(window), session_(session), script_(script), clock_(frames_per_second), turn_clock_(ticks_per_second) {
    if (script_.done()) session_.start_turning();  // a script has ticks of its own
  }

  void run() {
    while (going_on_ && !window_.should_close()) {
      measure();
      const double now = now_seconds();
      take_keys(now);
      if (clock_.take_due(session_.state().playing, now)) session_.advance();
      if (turn_clock_.take_due(session_.state().turning, now)) session_.turn_on();
      if (!going_on_) return;
      draw();
      window_.wait_for_events(idle_seconds());
    }
  }

 private:
  void measure() {
    const Size pixels = window_.size();
    size_ = {std::min(pixels.width, kLargestSide), std::min(pixels.height, kLargestSide)};
    visible_ = size_.width > 0 && size_.height > 0;
  }

  void take_keys(double now) {
    for (const KeyEvent& event : window_.take_key_events()) {
      if (event.pressed) {
        hold_.press(event.key, now);
        press(event.key);
      } else {
        hold_.release(event.key);
      }
    }
    const MouseMove mouse = window_.take_mouse_move();
    if (visible_ && (mouse.right != 0 || mouse.down != 0)) session_.drag(mouse.right, mouse.down);
    if (visible_ && mouse.notches != 0) session_.zoom(mouse.notches);
    if (const auto key = hold_.take_due(now)) press(*key);
    if (script_is_next()) press(*script_.take_next());
  }

  bool script_is_next() const { return visible_ && !script_.done() && !session_.state().playing; }

  void press(Key key) {
    if (!visible_ || !going_on_) return;
    try {
      going_on_ = session_.press(key, size_);
    } catch (const Error& error) {  // a file that cannot be written is no reason to lose the window
      fmt::print(stderr, "{}\n", error.what());
    }
  }

  void draw() {
    const bool damaged = window_.take_damage();
    if (visible_ && (damaged || shown_state_ != session_.state() || shown_size_ != size_)) {
      window_.show(session_.picture(size_));
      shown_state_ = session_.state();
      shown_size_ = size_;
    }
    if (std::string title = session_.title(); title != shown_title_) {
      window_.set_title(title);
      shown_title_ = std::move(title);
    }
  }

  double idle_seconds() const {
    if (script_is_next()) return 0.0;
    const double repeat = hold_.next_due().value_or(std::numeric_limits<double>::infinity());
    return std::max(0.0, std::min({repeat, clock_.next_due(), turn_clock_.next_due()}) - now_seconds());
  }

  Window& window_;
  DemoSession& session_;
  ScriptPlayer script_;
  HoldRepeat hold_;
  PlayClock clock_, turn_clock_;
  bool going_on_ = true;

  Size size_;             // of the window, now
  bool visible_ = false;  // not minimised
  std::optional<DemoState> shown_state_;
  Size shown_size_;
  std::string shown_title_;
};

}  // namespace

void run_window(Window& window, DemoSession& session, const std::vector<KeyPress>& script, double frames_per_second,
                double ticks_per_second) {
  WindowLoop(window, session, script, frames_per_second, ticks_per_second).run();
}

}  // namespace morphcl::viewer
