// The way back from a pixel, for people to read in a terminal.
#pragma once

#include <string>

#include "morphcl/trace.hpp"

namespace morphcl::cli {

void print_pixel_text(const std::string& scene, const PixelTrace& trace);

}  // namespace morphcl::cli
