// A demo without a window: presses the script's keys and writes the last picture.
#pragma once

#include <string>
#include <vector>

#include "demos/viewer/demo_session.hpp"
#include "demos/viewer/key_script.hpp"

namespace morphcl::viewer {

// `out` ends in .exr (the frame) or .png (the picture, with what the key h shows), or is empty.
void run_headless(FrameSource& frames, DemoSession& session, const std::vector<KeyPress>& script, const Size& size,
                  const std::string& out);

}  // namespace morphcl::viewer
