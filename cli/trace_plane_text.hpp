// The plane's pipeline of a 2-D shot, for people to read in a terminal.
#pragma once

#include "morphcl/trace.hpp"

namespace morphcl::cli {

void print_plane_text(const TracePlane& plane);

}  // namespace morphcl::cli
