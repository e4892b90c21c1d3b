// Composite transforms: an ordered list of named steps that is printed, inverted and evaluated as a whole.
//
// Convention (docs/conventions.md): column vectors, right-handed. Steps apply in the order they are added: the first
// one added meets the point first, so matrix() is Mn * ... * M2 * M1. Everything is composed in fp64; a caller that
// needs fp32 rounds the finished matrix once (host/math/rounding.hpp). Angles are degrees and exact at multiples of 90
// (host/math/angle.hpp).
//
// Two readings: a step moves the object in a fixed coordinate system. The same words about the coordinate system under
// a fixed object (translating or rotating the axes) mean the inverse map: inverse() of the composite is that reading.
//
// Errors: every adder throws Error(usage) for a NaN or infinite argument and, where named, for a degenerate one.
// Method: host/math/rotation.hpp. An axis is scaled by a power of two before it is normalised, so that its length does
// not matter from 1e-300 to 1e300.
#pragma once

#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "host/math/rounding.hpp"

namespace morphcl {

struct TransformStep {
  std::string name;    // "rotate_about_axis"
  std::string detail;  // "from (0, 0, 0) to (1, 0, 1), 30 degrees"
  glm::dmat4 matrix;   // affine
  glm::dmat4 inverse;  // from the step's own parameters; by cofactors for shear and matrix
  bool invertible = true;
};

class CompositeTransform {
 public:
  CompositeTransform& translate(const glm::dvec3& offset);
  CompositeTransform& scale(const glm::dvec3& factor);  // a factor of 0 is allowed; inverse() then refuses
  CompositeTransform& scale_about(const glm::dvec3& point, const glm::dvec3& factor);  // X + S (x - X)
  CompositeTransform& rotate_x_degrees(double degrees);
  CompositeTransform& rotate_y_degrees(double degrees);
  CompositeTransform& rotate_z_degrees(double degrees);
  // About the line from `from` to `to`, counter-clockwise seen from `to`; error when the two points are equal.
  CompositeTransform& rotate_about_axis(const glm::dvec3& from, const glm::dvec3& to, double degrees);
  // x' = x + xy*y + xz*z, y' = y + yx*x + yz*z, z' = z + zx*x + zy*y
  CompositeTransform& shear(double xy, double xz, double yx, double yz, double zx, double zy);
  CompositeTransform& matrix_step(const glm::dmat4& affine);  // error when the last row is not 0 0 0 1
  // A step of the caller's making: `matrix` is affine and `inverse` undoes it. Error when the matrix is not finite.
  CompositeTransform& add_step(TransformStep step);
  CompositeTransform& append(const CompositeTransform& after);

  const std::vector<TransformStep>& steps() const { return steps_; }
  glm::dmat4 matrix() const;           // error when the product overflows
  CompositeTransform inverse() const;  // steps inverted, in reverse order; error names the step that has no inverse
  std::string to_string() const;       // one numbered line a step: name and detail

 private:
  CompositeTransform& rotate(const char* name, const glm::dvec3& axis, double degrees);
  std::vector<TransformStep> steps_;
};

}  // namespace morphcl
