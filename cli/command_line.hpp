// The command line of the `morphcl` tool: reads the arguments, runs one command, turns every failure into one line on
// stderr and an exit code (morphcl/error.hpp names them; 1 and 75 come from `render` itself).
#pragma once

namespace morphcl::cli {

// Returns the exit code of the process. Throws nothing.
int run_command_line(int argc, char** argv);

}  // namespace morphcl::cli
