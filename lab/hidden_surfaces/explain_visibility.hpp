// Files that show what a frame's hidden-surface method did.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "morphcl/plan.hpp"

namespace morphcl::hidden_surfaces {

struct Explanation {
  std::vector<std::string> files;  // their names in the folder
  std::vector<std::pair<std::string, std::uint64_t>> counts;
  std::vector<std::string> lines;  // for people: the time, and the counts, aligned
};

// Runs the plan's method once more and writes, under names "METHOD.FRAME.", numbers.json, overdraw.png and
//   painter  order.csv, order.png
//   bsp      order.csv, order.png, tree.txt, tree.dot
//   warnock  windows.csv, quadtree.png
//   watkins  spans.csv, spans.png
// and, but for z-buffer, within_error.csv. Errors as those of drawing, and of write_file_atomically().
Explanation explain_visibility(const Plan& plan, const std::string& folder);

}  // namespace morphcl::hidden_surfaces
