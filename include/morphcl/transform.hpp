// Transforms of space: composed step by step, printed, inverted, taken apart, and rounded once for devices.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#pragma GCC visibility push(default)
namespace morphcl {

// ---- rounding -------------------------------------------------------------------------------------------------------
//
// From the fp64 of the host to the fp32 of the devices: each number is rounded once, to nearest, ties to even.
//
// Throws Error(usage) when a number is not finite or too large for fp32. What is too small becomes a denormal or 0.

float to_fp32(double value);
glm::vec3 to_fp32(const glm::dvec3& vector);
glm::vec4 to_fp32(const glm::dvec4& vector);
glm::mat3 to_fp32(const glm::dmat3& matrix);
glm::mat4 to_fp32(const glm::dmat4& matrix);
// GLM turns vectors and matrices of one size into another without a word, and loses what does not fit. What has no
// overload of its own does not compile.
template <class Other>
void to_fp32(const Other&) = delete;

// ---- composite transform --------------------------------------------------------------------------------------------
//
// An ordered list of named steps that is printed, inverted and evaluated as a whole. (The Transform of batches, made
// from one, is in batch.hpp.)
//
// Steps apply in the order they are added: the first one added meets the point first, so matrix() is
// Mn * ... * M2 * M1. Everything is composed in fp64; a caller that needs fp32 rounds the finished matrix once
// (to_fp32). Angles are degrees, exact at multiples of 90.
//
// Two readings: a step moves the object in a fixed coordinate system. The same words about the coordinate system under
// a fixed object (translating or rotating the axes) mean the inverse map: inverse() of the composite is that reading.
//
// Errors: every adder throws Error(usage) for a NaN or infinite argument and, where named, for a degenerate one.
// Method: rotation.hpp has that of rotations. An axis is scaled by a power of two before it is normalised, so that its
// length does not matter from 1e-300 to 1e300.

struct TransformStep {
  std::string name;    // "rotate_about_axis"
  std::string detail;  // "from (0, 0, 0) to (1, 0, 1), 30 degrees"
  glm::dmat4 matrix;   // affine
  glm::dmat4 inverse;  // from the step's own parameters, by cofactors for shear and matrix; 1 where there is none
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
  // A step of the caller's making: `matrix` is affine and `inverse` undoes it, which is not tested. Error when the
  // matrix is not finite.
  CompositeTransform& add_step(TransformStep step);
  CompositeTransform& append(const CompositeTransform& after);  // its steps meet the point after these

  const std::vector<TransformStep>& steps() const { return steps_; }
  glm::dmat4 matrix() const;           // error when the product overflows
  CompositeTransform inverse() const;  // steps inverted, in reverse order; error names the step that has no inverse
  std::string to_string() const;       // one numbered line a step: name and detail

 private:
  CompositeTransform& rotate(const char* name, const glm::dvec3& axis, double degrees);
  std::vector<TransformStep> steps_;
};

// ---- seven step rotation --------------------------------------------------------------------------------------------
//
// The classic way to rotate about any axis, for teaching: seven steps that each can be printed, drawn and undone.

// Counter-clockwise seen from `to`, like CompositeTransform::rotate_about_axis, but step by step. With the axis'
// direction (a, b, c), D = sqrt(b^2 + c^2) and L = sqrt(a^2 + b^2 + c^2):
//
//   1 translate        `from` to the origin
//   2 rotate about x   the axis into the xz plane: sin b/D, cos c/D
//   3 rotate about y   the axis onto z: sin -a/L, cos D/L
//   4 rotate about z   by the angle
//   5, 6, 7            3, 2 and 1 undone
//
// Error(usage) where these formulas have no answer: an axis of length 0, and one parallel to x (D = 0), for which step
// 2 is undefined although the rotation is not. They are computed as they stand: where squares underflow or overflow (D
// or L outside 1e-160 to 1e150) the steps are wrong. Use rotate_about_axis for everything but teaching.
CompositeTransform rotation_in_seven_steps(const glm::dvec3& from, const glm::dvec3& to, double degrees);

// ---- inverse --------------------------------------------------------------------------------------------------------
//
// Matrices are column-vector affine maps (last row 0 0 0 1) of finite entries. Cofactors are Kahan's differences of
// products of columns scaled by powers of two, so that scales from 1e-300 to 1e300 neither overflow nor vanish.

// Empty when the map is singular: when its determinant cannot be told from 0 after the rounding of its own evaluation
// (8u64 times the product of the lengths of the columns), when the inverse does not fit into fp64, or when an entry is
// not finite.
std::optional<glm::dmat4> try_affine_inverse(const glm::dmat4& affine);
template <class Other>
void try_affine_inverse(const Other&) = delete;  // GLM would turn a 3 x 3 matrix into a 4 x 4 one

// The same; throws Error(usage) where there is no inverse.
glm::dmat4 affine_inverse(const glm::dmat4& affine);
glm::dmat3 affine_inverse(
    const glm::dmat3& affine_2d);  // of the plane, see transform_2d.hpp; here so that it is not deleted
template <class Other>
void affine_inverse(const Other&) = delete;

// Transpose of the rotation, translation -R^T t. The upper 3x3 must be orthonormal; this is not tested.
glm::dmat4 rigid_inverse(const glm::dmat4& rigid);
template <class Other>
void rigid_inverse(const Other&) = delete;

// The inverse transpose of the upper 3x3 but for a positive factor that brings its largest entry into [0.5, 1): for
// normals, which are normalised afterwards. Made of cofactors without a division, so it exists for singular maps too: a
// surface that is flattened onto a plane gets that plane's normal. All zero when the map leaves a line or a point. A
// mirroring map keeps outward normals outward.
glm::dmat3 normal_matrix(const glm::dmat4& affine);
template <class Other>
void normal_matrix(const Other&) = delete;

// ---- decompose ------------------------------------------------------------------------------------------------------
//
// An affine map taken apart: translation * rotation * shear * scale.

struct Decomposition {
  glm::dvec3 translation;
  glm::dmat3 rotation;  // orthonormal within 16u64, determinant +1
  glm::dvec3 shear;     // xy, xz, yz: x' = x + xy*y + xz*z, y' = y + yz*z
  glm::dvec3 scale;     // x and y positive; z negative for a mirroring map
  // The largest difference between an entry of matrix() and of the map, over the length of its column. Less than
  // 120u64.
  double residual = 0;
  // How much of a box the images of the axes span: |determinant| over the product of their lengths, 1 where they are
  // at right angles. The closer to 0, the closer the map is to a singular one, and the more an error of its entries
  // matters to rotation and shear: about 1 / volume times as much.
  double volume = 1;

  glm::dmat4 matrix() const;
};

// The decomposition is unique: the x axis of the rotation is the image of x, its xy plane that of x and y (Gram and
// Schmidt in cross products, which do not cancel). Error(usage) when the map is not affine or finite, or singular: when
// its volume is below 8u64, so that rounding may have made it.
Decomposition decompose(const glm::dmat4& affine);
template <class Other>
void decompose(const Other&) = delete;

}  // namespace morphcl
#pragma GCC visibility pop
