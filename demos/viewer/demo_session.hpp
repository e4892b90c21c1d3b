// A demo that runs: the state that the keys change, and the picture of that state. Window and headless runs share it.
#pragma once

#include <string>

#include "demos/viewer/demo_settings.hpp"
#include "demos/viewer/demo_state.hpp"
#include "demos/viewer/frame_source.hpp"
#include "host/image/png_file.hpp"

namespace morphcl::viewer {

class DemoSession {
 public:
  DemoSession(const DemoSettings& settings, FrameSource& frames);

  const DemoState& state() const { return state_; }

  // One press; `size` is that of an exported frame, whose path goes to stdout. Returns whether the demo goes on. Throws
  // what FrameSource::export_frame() throws; the demo can go on then.
  bool press(Key key, const Size& size);
  void advance();  // one tick of playing
  void turn_on();  // one tick of turning
  void start_turning();

  // The mouse: dragged by pixels, and the wheel's notches towards the picture.
  void drag(int right, int down);
  void zoom(int notches);

  // What stands on the screen.
  RgbImage picture(const Size& size);

  // Name, step, projection, milliseconds of the last frame, and what was exported since the last key.
  std::string title() const;

 private:
  void export_frame(const Size& size);

  const DemoSettings& settings_;
  FrameSource& frames_;
  const DemoLimits limits_;
  DemoState state_;
  std::string notice_;
};

}  // namespace morphcl::viewer
