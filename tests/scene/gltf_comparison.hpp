// Compares an imported, animated glTF file with the independent evaluator, frame by frame.
#pragma once

#include <string>

namespace morphcl::test {

// Every node's matrix and every object's weights, from before the first key to after the last, at 120 frames a second.
// Returns the number of values compared, so that the caller can see that there were any.
std::size_t compare_with_evaluator(const std::string& path);

}  // namespace morphcl::test
