// A demo in a window: draws when something changed, sleeps when nothing happens.
#pragma once

#include <vector>

#include "demos/viewer/demo_session.hpp"
#include "demos/viewer/key_script.hpp"
#include "demos/viewer/window.hpp"

namespace morphcl::viewer {

// Until the window is closed. The script's presses are shown one by one, and wait while the animation plays.
// `ticks_per_second`: of a scene that turns.
void run_window(Window& window, DemoSession& session, const std::vector<KeyPress>& script, double frames_per_second,
                double ticks_per_second);

}  // namespace morphcl::viewer
