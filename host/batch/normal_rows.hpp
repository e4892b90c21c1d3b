// The matrix that takes normals along when points are transformed.
#pragma once

#include "host/batch/matrix_rows.hpp"

namespace morphcl {

// The inverse transpose of the linear part of `rows`, times the positive power of two that brings its largest entry to
// [1/2, 1]; the translations are 0. It is computed as the cofactor matrix with the determinant's sign, in fp64, each
// cofactor as Kahan's difference of products (host/math/kahan.hpp), and rounded once. From floats, whose products are
// exact in fp64, every entry is within u32 (1 + 2^-28) of its exact value, relative, or within 2^-150 where it is
// denormal. From doubles it is within 2 u64, relative, if no product of two entries is below 2^-900 times the square of
// the largest one.
//
// A singular matrix has no inverse; its cofactors still hold the normal of the plane that everything falls on, and are
// 0 where everything falls on a line. Its sign, and that of a determinant too near to 0 to tell, counts as positive.
// Error(usage) if an entry of the linear part is not finite.
template <class Real>
AffineRows<Real> normal_rows(const AffineRows<Real>& rows);

}  // namespace morphcl
