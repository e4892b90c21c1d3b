// Ways to round doubles to float and back that a compiler may make vectors of. GCC 12 loses the rounding in several of
// them when it may vectorize straight code. Each works on neighbours in memory.
#pragma once

#include <glm/glm.hpp>

namespace morphcl::test {

// values[i] = float(values[i]) for two, three, four and eight neighbours.
void round_pair(double* values);
void round_triple(double* values);
void round_four(double* values);
void round_eight(double* values);
// The same in a loop over `count`.
void round_all(double* values, int count);
// rounded[i] = float(1.5 values[i]) for two neighbours.
void scale_pair(double* rounded, const double* values);
// What rounding leaves: values[i] - float(values[i]), and the rounded part beside it.
void split_pair(double* high, double* low, const double* values);
// sum += vec3(direction), as directions of meshes are averaged.
void add_stored(glm::dvec3& sum, const glm::dvec3& direction);

}  // namespace morphcl::test
