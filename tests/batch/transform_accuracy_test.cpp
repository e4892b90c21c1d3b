// Accuracy of the batch transforms against 113-bit arithmetic, with bounds from the number of roundings.
//
// u is the relative error of one rounding, 2^-24 of floats and 2^-53 of doubles; gamma(k) = k u / (1 - k u) that of k
// in a row (Higham, Accuracy and Stability of Numerical Algorithms, lemma 3.1); a rounding that ends among the
// denormals adds at most half the smallest of them. The reference computes the device's bits
// (transform_buffers_test.cpp), so the device alone is judged here.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <limits>

#include "morphcl/batch.hpp"
#include "tests/batch/device_run.hpp"
#include "tests/device/shared_session.hpp"

namespace morphcl {
namespace {

using boost::multiprecision::abs;
using boost::multiprecision::sqrt;
using Exact = boost::multiprecision::cpp_bin_float_quad;
using Vector = std::array<Exact, 3>;

using testing::Batch;
using testing::Family;
using testing::general_matrix;
using testing::make_batch;
using testing::run_on_device;
using testing::shared_session;

constexpr std::size_t vertex_count = 3001;

template <class Real>
class TransformAccuracy : public ::testing::Test {
 protected:
  static Exact unit_roundoff() { return Exact(std::numeric_limits<Real>::epsilon()) / 2; }
  static Exact denormal_rounding() { return Exact(std::numeric_limits<Real>::denorm_min()) / 2; }
  static Exact gamma(int roundings) { return roundings * unit_roundoff() / (1 - roundings * unit_roundoff()); }

  // Exact value of row (x, y, z, w), and the sum of the absolute terms, which the rounding errors are relative to.
  struct Sum {
    Exact value = 0, magnitude = 0;

    Sum& operator+=(const Exact& term) {
      value += term;
      magnitude += abs(term);
      return *this;
    }
  };

  static Sum apply(const MatrixRow<Real>& row, const Batch<Real>& in, std::size_t i, int w, const Exact& weight = 1) {
    Sum sum;
    for (std::size_t axis = 0; axis < 3; ++axis) sum += weight * row[axis] * Exact(in.at(i, axis));
    return sum += weight * row[3] * w;
  }

  static Batch<Real> make(Family family, std::uint64_t seed) {
    return make_batch<Real>(VertexLayout::xyz, vertex_count, family, seed);
  }
};
using Precisions = ::testing::Types<float, double>;
TYPED_TEST_SUITE(TransformAccuracy, Precisions);

// Keeps the largest fraction of its bound that an error reached, so that a bound that says nothing is seen.
class Judge {
 public:
  template <class Real>
  void expect_within(Real actual, const Exact& expected, const Exact& bound, std::size_t element) {
    const Exact error = abs(Exact(actual) - expected);
    EXPECT_LE(error, bound) << "element " << element << ": actual " << actual << ", expected " << expected;
    if (bound > 0) largest_ = std::max(largest_, Exact(error / bound).template convert_to<double>());
  }
  ~Judge() { EXPECT_GT(largest_, 0.1) << "the bound is too wide to tell anything"; }

 private:
  double largest_ = 0;
};

template <class Real>
std::array<MatrixRow<Real>, 3> rows_of(const AffineRows<Real>& matrix) {
  return {matrix.x, matrix.y, matrix.z};
}

TYPED_TEST(TransformAccuracy, PointsThreeRoundings) {
  using Real = TypeParam;
  const std::pair<AffineRows<Real>, Family> cases[] = {{general_matrix<Real>(), Family::benign},
                                                       {general_matrix<Real>(), Family::wide},
                                                       {testing::cancelling_matrix<Real>(), Family::cancelling}};
  for (const auto& [matrix, family] : cases) {
    const auto in = this->make(family, 11);
    const auto out = run_on_device(shared_session(), Transform<Real>::points(matrix), in);
    Judge judge;
    for (std::size_t i = 0; i < vertex_count; ++i)
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto exact = this->apply(rows_of(matrix)[axis], in, i, 1);
        judge.expect_within(out.at(i, axis), exact.value,
                            this->gamma(3) * exact.magnitude + 3 * this->denormal_rounding(), i);
      }
  }
}

TYPED_TEST(TransformAccuracy, VectorsThreeRoundings) {
  using Real = TypeParam;
  const auto matrix = general_matrix<Real>();
  for (const Family family : {Family::benign, Family::wide}) {
    const auto in = this->make(family, 12);
    const auto out = run_on_device(shared_session(), Transform<Real>::vectors(matrix), in);
    Judge judge;
    for (std::size_t i = 0; i < vertex_count; ++i)
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto exact = this->apply(rows_of(matrix)[axis], in, i, 0);
        judge.expect_within(out.at(i, axis), exact.value,
                            this->gamma(3) * exact.magnitude + 3 * this->denormal_rounding(), i);
      }
  }
}

// Three roundings in each product and at most four in adding the weighted products: gamma(7) of the absolute terms.
TYPED_TEST(TransformAccuracy, BlendsSevenRoundings) {
  using Real = TypeParam;
  const auto palette = testing::make_palette<Real>(7);
  const auto blend = testing::make_blend<Real>(vertex_count, 7);
  const auto in = this->make(Family::benign, 15);
  const auto transform = Transform<Real>::points(std::span<const AffineRows<Real>>(palette));
  const auto out = run_on_device(shared_session(), transform, in, blend);
  Judge judge;
  for (std::size_t i = 0; i < vertex_count; ++i)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      typename TestFixture::Sum exact;
      for (std::size_t k = 0; k < 4; ++k) {
        const auto part =
            this->apply(rows_of(palette[blend.matrices[i][k]])[axis], in, i, 1, Exact(blend.weights[i][k]));
        exact.value += part.value;
        exact.magnitude += part.magnitude;
      }
      judge.expect_within(out.at(i, axis), exact.value, this->gamma(7) * exact.magnitude, i);
    }
}

// X/w: both sums carry gamma(3) of their magnitudes, the division one rounding more.
TYPED_TEST(TransformAccuracy, ProjectionsSumsAndOneDivision) {
  using Real = TypeParam;
  const auto matrix = testing::perspective_matrix<Real>();
  const MatrixRow<Real> rows[] = {matrix.x, matrix.y, matrix.z};
  const auto in = this->make(Family::benign, 13);
  const auto out = run_on_device(shared_session(), Transform<Real>::project(matrix), in);
  Judge judge;
  std::size_t judged = 0;
  for (std::size_t i = 0; i < vertex_count; ++i) {
    const auto w = this->apply(matrix.w, in, i, 1);
    const Exact w_error = this->gamma(3) * w.magnitude;
    if (w.value <= w_error) continue;  // behind the eye, or too near to tell
    ++judged;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto exact = this->apply(rows[axis], in, i, 1);
      const Exact quotient = exact.value / w.value;
      const Exact before_division = (this->gamma(3) * exact.magnitude + abs(quotient) * w_error) / (w.value - w_error);
      const Exact bound = before_division + this->unit_roundoff() * (abs(quotient) + before_division);
      judge.expect_within(out.at(i, axis), quotient, bound, i);
    }
  }
  EXPECT_GT(judged, vertex_count / 2);
}

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// Rows of the inverse transpose times a power of two (largest entry in [1/2, 1)).
template <class Real>
std::array<Vector, 3> exact_normal_rows(const AffineRows<Real>& matrix) {
  std::array<Vector, 3> rows;
  for (std::size_t row = 0; row < 3; ++row)
    for (std::size_t column = 0; column < 3; ++column) rows[row][column] = rows_of(matrix)[row][column];
  std::array<Vector, 3> normals = {cross(rows[1], rows[2]), cross(rows[2], rows[0]), cross(rows[0], rows[1])};
  Exact determinant = 0, largest = 0;
  for (std::size_t column = 0; column < 3; ++column) determinant += rows[0][column] * normals[0][column];
  for (const Vector& row : normals)
    for (const Exact& entry : row) largest = std::max(largest, Exact(abs(entry)));
  int exponent = 0;
  frexp(largest, &exponent);
  for (Vector& row : normals)
    for (Exact& entry : row) entry = ldexp(determinant < 0 ? -entry : entry, -exponent);
  return normals;
}

template <class Real>
std::vector<AffineRows<Real>> matrices_for_normals() {
  // Nearly flat: the cofactors lose most of their places to cancellation unless products are exact.
  const Real close = 64 * std::numeric_limits<Real>::epsilon();
  return {
      general_matrix<Real>(),
      {{Real(1e-6), Real(3e5), 1, 0}, {Real(-2e4), Real(1.7), Real(1e-3), 0}, {Real(0.3), Real(0.7), Real(-1.1), 0}},
      {{Real(1.1), Real(2.3), Real(3.7), 0},
       {Real(1.1) * (1 + close), Real(2.3), Real(3.7) * (1 + close), 0},
       {Real(-0.4), Real(0.9), Real(2.2), 0}}};
}

// One rounding of floats, after one in fp64; two of doubles, in a difference of products.
TYPED_TEST(TransformAccuracy, EntriesOfNormalRows) {
  const bool floats = std::is_same_v<TypeParam, float>;
  const Exact bound = floats ? this->unit_roundoff() * (1 + ldexp(Exact(1), -28)) : 2 * this->unit_roundoff();
  Judge judge;
  for (const auto& matrix : matrices_for_normals<TypeParam>()) {
    const auto actual = rows_of(normal_rows(matrix));
    const std::array<Vector, 3> exact = exact_normal_rows(matrix);
    for (std::size_t row = 0; row < 3; ++row)
      for (std::size_t column = 0; column < 3; ++column)
        judge.expect_within(actual[row][column], exact[row][column], bound * abs(exact[row][column]), 3 * row + column);
  }
}

// v = R n with at most two roundings in each entry of R and three in each sum: within gamma(5) of the sum of absolute
// terms. A vector off by e times its length points off by at most asin(e) <= e (1 + e) for e <= 1/2. The unit vector of
// the computed v then takes 3 roundings for the squared length, halved by the root, one for the root and one for the
// division: 3.5 u, within gamma(4).
TYPED_TEST(TransformAccuracy, NormalsSumsAndNormalisation) {
  using Real = TypeParam;
  for (const auto& matrix : matrices_for_normals<Real>()) {
    const std::array<Vector, 3> exact_rows = exact_normal_rows(matrix);
    for (const Family family : {Family::benign, Family::wide}) {
      const auto in = this->make(family, 14);
      const auto out = run_on_device(shared_session(), Transform<Real>::normals(matrix), in);
      std::size_t judged = 0;
      Judge judge;
      for (std::size_t i = 0; i < vertex_count; ++i) {
        Vector exact;
        Exact magnitude_squared = 0, length_squared = 0, actual_squared = 0;
        for (std::size_t row = 0; row < 3; ++row) {
          typename TestFixture::Sum sum;
          for (std::size_t axis = 0; axis < 3; ++axis) sum += exact_rows[row][axis] * Exact(in.at(i, axis));
          exact[row] = sum.value;
          magnitude_squared += sum.magnitude * sum.magnitude;
          length_squared += sum.value * sum.value;
          actual_squared += Exact(out.at(i, row)) * out.at(i, row);
        }
        const Exact length = sqrt(length_squared);
        const Exact turned = this->gamma(5) * sqrt(magnitude_squared) / length;
        if (turned > 0.5) continue;  // nothing is left of the direction
        ++judged;
        for (std::size_t axis = 0; axis < 3; ++axis) {
          const Exact expected = exact[axis] / length;
          const Exact bound = turned * (1 + turned) + this->gamma(4) * (abs(expected) + turned);
          judge.expect_within(out.at(i, axis), expected, bound, i);
        }
        EXPECT_LE(abs(sqrt(actual_squared) - 1), this->gamma(4)) << "length of normal " << i;
      }
      EXPECT_GT(judged, vertex_count * 9 / 10);
    }
  }
}

}  // namespace
}  // namespace morphcl
