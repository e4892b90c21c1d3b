#include "bench/kernels/transform_peers.hpp"

#include <glm/glm.hpp>

#include "bench/kernels/transform_copy.hpp"

#ifdef MORPHCL_BENCH_EIGEN
#include <Eigen/Core>
#endif

namespace morphcl::bench {

namespace {

template <class Real>
Real row_times(const std::array<Real, 4>& row, Real x, Real y, Real z) {
  return row[0] * x + row[1] * y + row[2] * z + row[3];
}

template <class Real>
glm::mat<4, 4, Real> glm_matrix(const Rows<Real>& rows) {
  glm::mat<4, 4, Real> matrix(1);
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 4; ++column)
      matrix[column][row] = rows[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)];
  return matrix;
}

template <class Real, int reals_per_vertex>
void transform_records(const glm::mat<4, 4, Real>& matrix, const Real* in, Real* out, std::size_t count) {
  using Record = glm::vec<reals_per_vertex, Real>;
  const auto* records = reinterpret_cast<const Record*>(in);
  auto* results = reinterpret_cast<Record*>(out);
  for (std::size_t i = 0; i < count; ++i)
    results[i] = Record(matrix * glm::vec<4, Real>(glm::vec<3, Real>(records[i]), Real{1}));
}

}  // namespace

template <class Real>
void transform_with_loop(const Rows<Real>& rows, const Arrays<Real>& in, const Arrays<Real>& out, std::size_t count,
                         int threads) {
  on_threads(threads, count, [&](std::size_t first, std::size_t size) {
    const Real* __restrict x = in.x + first, * __restrict y = in.y + first, * __restrict z = in.z + first;
    Real* __restrict out_x = out.x + first, * __restrict out_y = out.y + first, * __restrict out_z = out.z + first;
    const Rows<Real> matrix = rows;
    for (std::size_t i = 0; i < size; ++i) {
      out_x[i] = row_times(matrix[0], x[i], y[i], z[i]);
      out_y[i] = row_times(matrix[1], x[i], y[i], z[i]);
      out_z[i] = row_times(matrix[2], x[i], y[i], z[i]);
    }
  });
}

template <class Real>
void transform_with_glm(const Rows<Real>& rows, const Real* in, Real* out, std::size_t reals_per_vertex,
                        std::size_t count, int threads) {
  const auto matrix = glm_matrix(rows);
  on_threads(threads, count, [&](std::size_t first, std::size_t size) {
    const std::size_t at = first * reals_per_vertex;
    if (reals_per_vertex == 3)
      transform_records<Real, 3>(matrix, in + at, out + at, size);
    else
      transform_records<Real, 4>(matrix, in + at, out + at, size);
  });
}

template <class Real>
void transform_with_eigen([[maybe_unused]] const Rows<Real>& rows, [[maybe_unused]] const Real* in,
                          [[maybe_unused]] Real* out, [[maybe_unused]] std::size_t count,
                          [[maybe_unused]] int threads) {
#ifdef MORPHCL_BENCH_EIGEN
  Eigen::Matrix<Real, 4, 4> matrix = Eigen::Matrix<Real, 4, 4>::Identity();
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 4; ++column)
      matrix(row, column) = rows[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)];
  on_threads(threads, count, [&](std::size_t first, std::size_t size) {
    using Records = Eigen::Matrix<Real, 4, Eigen::Dynamic>;
    const auto columns = static_cast<Eigen::Index>(size);
    Eigen::Map<Records>(out + 4 * first, 4, columns).noalias() =
        matrix * Eigen::Map<const Records>(in + 4 * first, 4, columns);
  });
#endif
}

#define FOR_REAL(Real)                                                                                              \
  template void transform_with_loop(const Rows<Real>&, const Arrays<Real>&, const Arrays<Real>&, std::size_t, int); \
  template void transform_with_glm(const Rows<Real>&, const Real*, Real*, std::size_t, std::size_t, int);           \
  template void transform_with_eigen(const Rows<Real>&, const Real*, Real*, std::size_t, int);
FOR_REAL(float)
FOR_REAL(double)

}  // namespace morphcl::bench
