#include "cli/command_line.hpp"
#include "cli/stop_signals.hpp"
#include "host/standard_streams.hpp"

int main(int argc, char** argv) {
  morphcl::open_closed_standard_streams();
  morphcl::cli::watch_stop_signals();
  return morphcl::cli::run_command_line(argc, argv);
}
