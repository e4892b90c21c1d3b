// The whole program of a demo.
#pragma once

#include "demos/viewer/demo_settings.hpp"

namespace morphcl::viewer {

// `deck`: other settings of the same program, for the option --deck; their description is that of the option. Returns
// the exit code: 0, or that of the error (morphcl/error.hpp) whose one line went to stderr.
int run_demo(const DemoSettings& settings, int argc, const char* const* argv, const DemoSettings* deck = nullptr);

}  // namespace morphcl::viewer
