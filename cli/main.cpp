#include "cli/command_line.hpp"
#include "cli/end_process.hpp"
#include "cli/stop_signals.hpp"
#include "host/standard_streams.hpp"

int main(int argc, char** argv) {
  morphcl::open_closed_standard_streams();
  morphcl::cli::watch_stop_signals();
  const int code = morphcl::cli::run_command_line(argc, argv);
  if (morphcl::cli::thread_left_at_work()) morphcl::cli::end_process(code);
  return code;
}
