#include "demos/viewer/demo_session.hpp"

#include <fmt/format.h>

#include <cstdio>

#include "demos/viewer/overlay.hpp"
#include "demos/viewer/picture.hpp"
#include "morphcl/error.hpp"

namespace morphcl::viewer {

DemoSession::DemoSession(const DemoSettings& settings, FrameSource& frames)
    : settings_(settings), frames_(frames), limits_(frames.limits()) {
  state_.view = frames.first_view();
}

bool DemoSession::press(Key key, const Size& size) {
  notice_.clear();
  const Transition transition = apply(state_, key, limits_);
  state_ = transition.state;
  if (transition.action == Action::export_frame) export_frame(size);
  return transition.action != Action::leave;
}

void DemoSession::advance() { state_ = viewer::advance(state_, limits_); }

void DemoSession::turn_on() { state_ = viewer::turn_on(state_, limits_); }

void DemoSession::start_turning() { state_.turning = limits_.turn_ticks > 0; }

void DemoSession::drag(int right, int down) { state_ = viewer::drag(state_, right, down); }

void DemoSession::zoom(int notches) { state_ = viewer::zoom(state_, notches); }

RgbImage DemoSession::picture(const Size& size) {
  RgbImage picture = picture_of(frames_.render(state_.view, size));
  if (state_.help) draw_text_box(help_lines(limits_), picture);
  return picture;
}

void DemoSession::export_frame(const Size& size) {
  notice_ = " - frame was not written";
  const std::string path = frames_.export_frame(state_.view, size, settings_.name + ".####.exr");
  fmt::print("{}\n", path);
  std::fflush(stdout);
  notice_ = " - wrote " + printable(path);
}

std::string DemoSession::title() const {
  const View& view = state_.view;
  const std::string step = limits_.last_step > 0 ? fmt::format(" - step {} of {}", view.step, limits_.last_step) : "";
  const char* projection = view.projection == ProjectionKind::orthographic ? "orthographic" : "frustum";
  return fmt::format("{}{} - {} - {:.1f} ms - h: keys{}", settings_.name, step, projection, frames_.milliseconds(),
                     notice_);
}

}  // namespace morphcl::viewer
