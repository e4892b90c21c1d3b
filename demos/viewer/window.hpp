// A window that shows finished pictures and tells which keys were pressed and how the mouse moved. Nothing is drawn
// here but the picture's pixels.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "demos/viewer/frame_source.hpp"
#include "demos/viewer/key.hpp"
#include "host/image/png_file.hpp"

namespace morphcl::viewer {

struct KeyEvent {
  Key key;
  bool pressed;  // else released
};

// What the mouse did: dragged with the left button down, pixels, and the wheel's notches away from the user.
struct MouseMove {
  int right = 0, down = 0, notches = 0;
};

class Window {
 public:
  // Error(no_device) where there is no display, or no OpenGL on it. One window a process.
  Window(const std::string& title, const Size& size);
  ~Window();

  bool should_close() const;
  Size size() const;  // of the pixels inside; a side of 0: minimised
  void set_title(const std::string& title);

  // Pixel for pixel, from the upper left corner of the window; what the picture does not reach is black.
  void show(const RgbImage& picture);

  // Waits for an event, at most `seconds` (infinity: for as long as it takes; 0: not at all), and handles all there
  // are.
  void wait_for_events(double seconds);

  std::vector<KeyEvent> take_key_events();  // since the last call, in order
  MouseMove take_mouse_move();              // since the last call, in all
  bool take_damage();                       // whether the window's content was lost since the last call

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace morphcl::viewer
