// A trace for people to read in a terminal.
#pragma once

#include "morphcl/trace.hpp"

namespace morphcl::cli {

void print_trace_text(const std::string& scene, const Trace& trace);

}  // namespace morphcl::cli
