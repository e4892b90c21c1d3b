// What morphcl compare prints of a frame: a table for people, or JSON lines.
#pragma once

#include "lab/frame_error/frame_difference.hpp"

namespace morphcl::cli {

void print_difference_table(const accuracy::FrameDifference& difference);
void print_difference_json(const accuracy::FrameDifference& difference);  // the frame, then each object

}  // namespace morphcl::cli
