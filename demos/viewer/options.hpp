// The command line of the demos.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "demos/viewer/demo_settings.hpp"
#include "demos/viewer/frame_source.hpp"
#include "demos/viewer/key_script.hpp"

namespace morphcl::viewer {

struct DemoOptions {
  bool deck = false;             // the settings of the lecture's own picture
  std::string shot;              // path; empty: the demo's own
  std::vector<KeyPress> script;  // pressed one after the other, before the keyboard
  bool headless = false;
  std::string out;              // headless: the file of the last frame, .exr or .png; empty: none
  std::string device = "auto";  // or "reference", or as SessionOptions::device
  int threads = 0;              // as SessionOptions::threads
  Size size;
};

// None when --help was asked for and printed. Error(usage) for everything that makes no sense.
// `deck`: settings that --deck chooses, where a demo has them.
std::optional<DemoOptions> parse_options(const DemoSettings& settings, const DemoSettings* deck, int argc,
                                         const char* const* argv);

}  // namespace morphcl::viewer
