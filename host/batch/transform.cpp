#include "host/batch/transform.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "host/batch/usage_error.hpp"
#include "kernels/transform_kind.h"
#include "morphcl/batch.hpp"

namespace morphcl {

static_assert(static_cast<int>(TransformKind::affine) == TRANSFORM_AFFINE &&
              static_cast<int>(TransformKind::projective) == TRANSFORM_PROJECTIVE &&
              static_cast<int>(TransformKind::normals) == TRANSFORM_NORMALS);

namespace {

// Row numbers are 32 bits wide in the kernels.
constexpr std::size_t max_matrices = std::size_t{1} << 28;

Error bad_matrix(std::size_t vertex, std::size_t asked, std::size_t matrix_count) {
  return usage_error(fmt::format("vertex {} asks for matrix {}, but there are {}; the last one is number {}", vertex,
                                 asked, matrix_count, matrix_count - 1));
}

template <class Real>
AffineRows<Real> without_translation(AffineRows<Real> matrix) {
  // -0 is what adds nothing, not even to -0: the product with z stays as it is rounded alone.
  for (MatrixRow<Real>* row : {&matrix.x, &matrix.y, &matrix.z}) (*row)[3] = Real{-0.0};
  return matrix;
}

}  // namespace

template <class Real>
Transform<Real>::Transform(TransformKind kind, std::size_t matrix_count) : kind_(kind) {
  if (matrix_count == 0 || matrix_count > max_matrices)
    throw usage_error(fmt::format("{} matrices for a batch; 1 to {} are possible", matrix_count, max_matrices));
  rows_.reserve(matrix_count * rows_per_matrix());
}

template <class Real>
void Transform<Real>::add(const AffineRows<Real>& matrix) {
  rows_.insert(rows_.end(), {matrix.x, matrix.y, matrix.z});
}

template <class Real>
Transform<Real> Transform<Real>::points(std::span<const AffineRows<Real>> matrices) {
  Transform transform(TransformKind::affine, matrices.size());
  for (const auto& matrix : matrices) transform.add(matrix);
  return transform;
}

template <class Real>
Transform<Real> Transform<Real>::vectors(std::span<const AffineRows<Real>> matrices) {
  Transform transform(TransformKind::affine, matrices.size());
  for (const auto& matrix : matrices) transform.add(without_translation(matrix));
  return transform;
}

template <class Real>
Transform<Real> Transform<Real>::normals(std::span<const AffineRows<Real>> matrices) {
  Transform transform(TransformKind::normals, matrices.size());
  for (const auto& matrix : matrices) transform.add(without_translation(normal_rows(matrix)));
  return transform;
}

template <class Real>
Transform<Real> Transform<Real>::project(std::span<const ProjectiveRows<Real>> matrices) {
  Transform transform(TransformKind::projective, matrices.size());
  for (const auto& matrix : matrices)
    transform.rows_.insert(transform.rows_.end(), {matrix.x, matrix.y, matrix.z, matrix.w});
  return transform;
}

template <class Real>
void check_choice_kind(const Transform<Real>& transform, bool chosen, bool blended) {
  if (!chosen && transform.matrix_count() != 1)
    throw usage_error(
        fmt::format("{} matrices and no choice among them; an index a vertex is needed", transform.matrix_count()));
  if (blended && transform.kind() == TransformKind::normals)
    throw usage_error("normals cannot be blended; blend vectors where all matrices are rotations");
}

template <class Real>
void check_choice(const Transform<Real>& transform, const MatrixChoice<Real>& choice, std::size_t count) {
  const auto* index = std::get_if<MatrixIndices>(&choice);
  const auto* blend = std::get_if<MatrixBlend<Real>>(&choice);
  check_choice_kind(transform, index || blend, blend != nullptr);
  if (index && index->size() != count)
    throw usage_error(fmt::format("{} matrix indices for {} vertices; one each is needed", index->size(), count));
  if (blend && (blend->matrices.size() != count || blend->weights.size() != count))
    throw usage_error(fmt::format("{} quadruples of matrices and {} of weights for {} vertices; one each is needed",
                                  blend->matrices.size(), blend->weights.size(), count));
}

template <class Real>
void check_indices(const Transform<Real>& transform, const MatrixChoice<Real>& choice) {
  const std::size_t matrix_count = transform.matrix_count();
  if (const auto* index = std::get_if<MatrixIndices>(&choice)) {
    for (std::size_t i = 0; i < index->size(); ++i)
      if ((*index)[i] >= matrix_count) throw bad_matrix(i, (*index)[i], matrix_count);
  } else if (const auto* blend = std::get_if<MatrixBlend<Real>>(&choice)) {
    for (std::size_t i = 0; i < blend->matrices.size(); ++i)
      for (const std::uint16_t matrix : blend->matrices[i])
        if (matrix >= matrix_count) throw bad_matrix(i, matrix, matrix_count);
  }
}

template <class Real>
MatrixChoice<Real> part(const MatrixChoice<Real>& choice, std::size_t first, std::size_t count) {
  if (const auto* index = std::get_if<MatrixIndices>(&choice)) return index->subspan(first, count);
  if (const auto* blend = std::get_if<MatrixBlend<Real>>(&choice))
    return MatrixBlend<Real>{blend->matrices.subspan(first, count), blend->weights.subspan(first, count)};
  return {};
}

template class Transform<float>;
template class Transform<double>;
template void check_choice_kind(const Transform<float>&, bool, bool);
template void check_choice_kind(const Transform<double>&, bool, bool);
template void check_choice(const Transform<float>&, const MatrixChoice<float>&, std::size_t);
template void check_choice(const Transform<double>&, const MatrixChoice<double>&, std::size_t);
template void check_indices(const Transform<float>&, const MatrixChoice<float>&);
template void check_indices(const Transform<double>&, const MatrixChoice<double>&);
template MatrixChoice<float> part(const MatrixChoice<float>&, std::size_t, std::size_t);
template MatrixChoice<double> part(const MatrixChoice<double>&, std::size_t, std::size_t);

}  // namespace morphcl
