// Other ways to transform points by one matrix: what one would write without morphcl, compiled for this processor with
// -O3. Matrices are three rows of four. Real is float or double.
#pragma once

#include <array>
#include <cstddef>

namespace morphcl::bench {

template <class Real>
using Rows = std::array<std::array<Real, 4>, 3>;

template <class Real>
struct Arrays {
  Real *x, *y, *z;
};

// A loop over separate arrays that the compiler vectorises.
template <class Real>
void transform_with_loop(const Rows<Real>& rows, const Arrays<Real>& in, const Arrays<Real>& out, std::size_t count,
                         int threads);

// GLM: mat4 * vec4(p, 1), record by record of three or four reals.
template <class Real>
void transform_with_glm(const Rows<Real>& rows, const Real* in, Real* out, std::size_t reals_per_vertex,
                        std::size_t count, int threads);

// Eigen: a 4 x 4 matrix times a 4 x count matrix, for records of four of which the last is 1; on the calling thread.
// Does nothing without Eigen (MORPHCL_BENCH_EIGEN).
template <class Real>
void transform_with_eigen(const Rows<Real>& rows, const Real* in, Real* out, std::size_t count, int threads);

}  // namespace morphcl::bench
