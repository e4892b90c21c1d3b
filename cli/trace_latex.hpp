// A trace as a LaTeX document that compiles by itself: pdflatex with amsmath.
#pragma once

#include <string>

#include "morphcl/trace.hpp"

namespace morphcl::cli {

void print_trace_latex(const std::string& scene, const Trace& trace);
void print_pixel_latex(const std::string& scene, const PixelTrace& trace);  // the way back, then `forward`

}  // namespace morphcl::cli
