#include <fmt/format.h>

#include <cmath>

#include "host/batch/usage_error.hpp"
#include "morphcl/batch.hpp"

namespace morphcl {

namespace {

template <class Real>
MatrixRow<Real> row_of(const glm::dmat4& matrix, int row) {
  MatrixRow<Real> rounded;
  for (int column = 0; column < 4; ++column) {
    const double entry = matrix[column][row];
    rounded[static_cast<std::size_t>(column)] = static_cast<Real>(entry);
    if (!std::isfinite(rounded[static_cast<std::size_t>(column)]))
      throw usage_error(fmt::format("row {}, column {} of a matrix is {}, which is no finite number of {} bits", row,
                                    column, entry, 8 * sizeof(Real)));
  }
  return rounded;
}

}  // namespace

template <class Real>
AffineRows<Real> affine_rows(const glm::dmat4& affine) {
  const MatrixRow<double> last = row_of<double>(affine, 3);
  if (last != MatrixRow<double>{0, 0, 0, 1})
    throw usage_error(fmt::format("the last row of a matrix is {} {} {} {}; of an affine one it is 0 0 0 1", last[0],
                                  last[1], last[2], last[3]));
  return {row_of<Real>(affine, 0), row_of<Real>(affine, 1), row_of<Real>(affine, 2)};
}

template <class Real>
ProjectiveRows<Real> projective_rows(const glm::dmat4& matrix) {
  return {row_of<Real>(matrix, 0), row_of<Real>(matrix, 1), row_of<Real>(matrix, 2), row_of<Real>(matrix, 3)};
}

template AffineRows<float> affine_rows(const glm::dmat4&);
template AffineRows<double> affine_rows(const glm::dmat4&);
template ProjectiveRows<float> projective_rows(const glm::dmat4&);
template ProjectiveRows<double> projective_rows(const glm::dmat4&);

}  // namespace morphcl
