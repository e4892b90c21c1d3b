#include "cli/command_line.hpp"
#include "host/standard_streams.hpp"

int main(int argc, char** argv) {
  morphcl::open_closed_standard_streams();
  return morphcl::cli::run_command_line(argc, argv);
}
