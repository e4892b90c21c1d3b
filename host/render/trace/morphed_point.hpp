// Where a vertex is in object space at a frame, by its base and the weights of its targets.
#pragma once

#include <vector>

#include "morphcl/trace.hpp"

namespace morphcl {

// Sets base, targets and start. `weights`: one a target.
//
// The bound: fp32 rounds each weight once and applies a target in two fma, of which the inner one, v - w p, is exact
// for differences; sizes of intermediate values are those of fp64 plus their own error.
void morph_point(const Mesh& mesh, std::size_t vertex, const std::vector<double>& weights, Trace& trace);

// A point of the caller's, rounded to fp32 once.
TracePoint start_at(const glm::dvec3& point);

}  // namespace morphcl
