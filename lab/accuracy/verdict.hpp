// Which variant is enough, what a better one costs, and which variants nothing else beats.
#pragma once

#include <string>
#include <vector>

#include "lab/accuracy/operation.hpp"

namespace morphcl::accuracy {

// The results of `family` that no other one is both faster and at least as accurate than, by increasing time: the first
// one that a result has. Results that are not finite, or were not timed, are not among them.
std::vector<const Result*> pareto_front(const OperationReport& report, const std::string& family);

// One sentence a family: the cheapest variant within the target and its cost, and the next better one and what it
// costs; or that none is within it, and the best.
std::string verdict(const OperationReport& report, const std::string& family);

}  // namespace morphcl::accuracy
