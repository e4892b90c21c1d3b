// One page of plots: x is time an element, y the error, a panel for each operation and family and, right of an
// operation's, the names of its marks.
#pragma once

#include <string>

#include "lab/accuracy/report.hpp"

namespace morphcl::accuracy {

// The gnuplot program that draws `report` into the SVG file `path`. A mark a variant, filled where morphcl computes so,
// its name beside it; the Pareto front as a line; the target as a dashed one. Errors of 0 lie on the lower edge.
std::string plot_program(const Report& report, const std::string& path);

// Draws it, whole or not at all. Returns "" or one line: what is missing or went wrong (gnuplot is an external
// program).
std::string draw_plots(const Report& report, const std::string& path);

}  // namespace morphcl::accuracy
