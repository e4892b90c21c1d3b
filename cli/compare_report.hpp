// What morphcl compare prints of a frame: a table for people, or JSON lines.
#pragma once

#include <string>

#include "lab/frame_error/frame_difference.hpp"

namespace morphcl::cli {

// `drawn_by`: Renderer::drawn_by() of the frame.
void print_difference_table(const accuracy::FrameDifference& difference, const std::string& drawn_by);
// The frame, then each object.
void print_difference_json(const accuracy::FrameDifference& difference, const std::string& drawn_by);

}  // namespace morphcl::cli
