#include "cli/command_line.hpp"
#include "cli/stop_signals.hpp"
#include "host/end_process.hpp"
#include "host/standard_streams.hpp"

int main(int argc, char** argv) {
  morphcl::open_closed_standard_streams();
  morphcl::cli::watch_stop_signals();
  const int code = morphcl::cli::run_command_line(argc, argv);
  if (morphcl::thread_left_at_work()) morphcl::end_process(code);
  return code;
}
