// What a method did, as text: tables (CSV), a tree (text and DOT), numbers (JSON).
#pragma once

#include <string>

#include "lab/hidden_surfaces/method_run.hpp"

namespace morphcl::hidden_surfaces {

std::string numbers_json(const MethodRun& run);  // one object

// Pixels where the stored depths decided what planes alone would have shown otherwise.
std::string within_error_csv(const MethodRun& run);

std::string windows_csv(const MethodRun& run);  // warnock: every window, a window before its parts
std::string spans_csv(const MethodRun& run);    // watkins: every sample span, row by row
std::string order_csv(const MethodRun& run);    // painter, bsp: every piece, back to front

// bsp: every node, indented by its depth; of each the back side first, as the eye walks it.
std::string tree_text(const MethodRun& run);
// The same for Graphviz, the first `max_depth` levels.
std::string tree_dot(const MethodRun& run, int max_depth = 7);

}  // namespace morphcl::hidden_surfaces
