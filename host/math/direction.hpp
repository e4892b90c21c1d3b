// Vectors as directions: scaled and normalised without overflow or underflow, whatever their length.
#pragma once

#include <glm/glm.hpp>

namespace morphcl {

// A vector times the power of two that brings its largest component into [0.5, 1): exact, except that components 2^1021
// times smaller than the largest may lose bits. 0 stays 0. The vector must be finite.
struct ScaledVector {
  glm::dvec3 vector;
  int exponent;  // original = vector * 2^exponent
};
ScaledVector scale_to_one(const glm::dvec3& vector);

// Unit length within 4u relative a component; 0 stays 0. Vectors that differ by a power of two give the same bits, a
// vector along a coordinate axis gives exactly that axis. The vector must be finite.
glm::dvec3 unit(const glm::dvec3& vector);

// to - from as high + low without rounding; halved where it would overflow (only its direction is meant).
struct Difference {
  glm::dvec3 high, low;
};
Difference direction_from_to(const glm::dvec3& from, const glm::dvec3& to);

}  // namespace morphcl
