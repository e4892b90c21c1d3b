// What a batch transform does to its vertices: one matrix, or a palette of which each vertex chooses.
//
// Executed on a device by transform_vertices.hpp (memory of the host) and transform_buffers.hpp (buffers of the
// device), and in plain loops by transform_reference.hpp: the same bits.
//
// A coordinate of the product of a row m and (x, y, z) is fma(x, m0, fma(y, m1, fma(z, m2, m3))), at most 3 roundings.
//   points    that product
//   vectors   the same without translations
//   project   (X, Y, Z) / w of the four products; a point with w <= 0 or NaN has no image: +infinity, three times
//   normals   unit normals of the transformed surface, from normal_rows(rows) for the matrix `rows` that the points are
//             transformed with. Lengths from denormal to near overflow are safe; a normal of length 0, or one that the
//             matrix takes to 0, gives 0. Normals as long as the matrix makes them are vectors(normal_rows(rows)).
// Infinities and NaN follow IEEE 754; which NaN a result is, is not promised.
#pragma once

#include <cstdint>
#include <span>
#include <variant>
#include <vector>

#include "host/batch/matrix_rows.hpp"
#include "kernels/transform_kind.h"

namespace morphcl {

enum class TransformKind : std::uint32_t {
  affine = TRANSFORM_AFFINE,
  projective = TRANSFORM_PROJECTIVE,
  normals = TRANSFORM_NORMALS
};

template <class Real>
class Transform {
 public:
  // Error(usage) if there is no matrix, or more than 2^28; of normals() also if an entry is not finite.
  static Transform points(std::span<const AffineRows<Real>> matrices);
  static Transform vectors(std::span<const AffineRows<Real>> matrices);
  static Transform normals(std::span<const AffineRows<Real>> matrices);
  static Transform project(std::span<const ProjectiveRows<Real>> matrices);

  static Transform points(const AffineRows<Real>& matrix) { return points(std::span(&matrix, 1)); }
  static Transform vectors(const AffineRows<Real>& matrix) { return vectors(std::span(&matrix, 1)); }
  static Transform normals(const AffineRows<Real>& matrix) { return normals(std::span(&matrix, 1)); }
  static Transform project(const ProjectiveRows<Real>& matrix) { return project(std::span(&matrix, 1)); }

  TransformKind kind() const { return kind_; }
  std::size_t rows_per_matrix() const { return kind_ == TransformKind::projective ? 4 : 3; }
  std::size_t matrix_count() const { return rows_.size() / rows_per_matrix(); }
  std::span<const MatrixRow<Real>> rows() const { return rows_; }  // as they are multiplied, matrix by matrix

 private:
  Transform(TransformKind kind, std::size_t matrix_count);
  void add(const AffineRows<Real>& matrix);

  TransformKind kind_;
  std::vector<MatrixRow<Real>> rows_;
};

// Vertex i goes through matrix index[i].
using MatrixIndices = std::span<const std::uint32_t>;

// Vertex i goes through the sum over k of weights[i][k] times matrix matrices[i][k], as skins are blended. The product
// with each matrix is rounded as above; the sum is the first product with its weight, rounded, and one fma for each of
// the others. Not for normals, as the inverse transpose of a sum is no sum of inverse transposes; where all matrices
// are rotations, vectors do.
template <class Real>
struct MatrixBlend {
  std::span<const std::array<std::uint16_t, 4>> matrices;
  std::span<const std::array<Real, 4>> weights;
};

// Nothing where all vertices go through the only matrix there is.
template <class Real>
using MatrixChoice = std::variant<std::monostate, MatrixIndices, MatrixBlend<Real>>;

// Error(usage) where there is no choice among several matrices, or a blend of normals.
template <class Real>
void check_choice_kind(const Transform<Real>& transform, bool chosen, bool blended);

// The same, and Error(usage) where the choice is for another number of vertices than `count`.
template <class Real>
void check_choice(const Transform<Real>& transform, const MatrixChoice<Real>& choice, std::size_t count);

// Error(usage) naming the first vertex that asks for a matrix past the last one, if any does.
template <class Real>
void check_indices(const Transform<Real>& transform, const MatrixChoice<Real>& choice);

// The choices of vertices `first` to `first + count - 1`.
template <class Real>
MatrixChoice<Real> part(const MatrixChoice<Real>& choice, std::size_t first, std::size_t count);

}  // namespace morphcl
