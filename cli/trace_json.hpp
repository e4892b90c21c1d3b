// A trace as JSON, one object a line (docs/json.md).
#pragma once

#include "morphcl/trace.hpp"

namespace morphcl::cli {

void print_trace_json(const Trace& trace);
void print_pixel_json(const PixelTrace& trace);  // the way back, then `forward`

}  // namespace morphcl::cli
