// The whole program of a demo.
#pragma once

#include "demos/viewer/demo_settings.hpp"

namespace morphcl::viewer {

// Returns the exit code: 0, or that of the error (morphcl/error.hpp) whose one line went to stderr.
int run_demo(const DemoSettings& settings, int argc, const char* const* argv);

}  // namespace morphcl::viewer
