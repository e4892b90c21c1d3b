// Accuracy of the batch transforms against 113-bit arithmetic, with bounds from the number of roundings.
//
// u = 2^-24 is the relative error of one rounding, gamma(k) = k u / (1 - k u) of k in a row (Higham, Accuracy and
// Stability of Numerical Algorithms, lemma 3.1); a rounding that ends among the denormals adds at most 2^-150. The
// device computes the reference's bits (transform_points_test.cpp), so the device alone is judged here.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <string>

#include "host/device/normal_rows.hpp"
#include "host/device/transform_points.hpp"
#include "tests/device/shared_session.hpp"
#include "tests/device/test_points.hpp"

namespace morphcl {
namespace {

using boost::multiprecision::abs;
using boost::multiprecision::sqrt;
using Real = boost::multiprecision::cpp_bin_float_quad;
using Vector = std::array<Real, 3>;

using testing::cancelling_matrix;
using testing::Family;
using testing::general_matrix;
using testing::make_points;
using testing::perspective_matrix;
using testing::Points;
using testing::shared_session;

constexpr std::size_t point_count = 3001;
const Real unit_roundoff = Real(0x1p-24);
const Real denormal_rounding = ldexp(Real(1), -150);

Real gamma(int roundings) { return roundings * unit_roundoff / (1 - roundings * unit_roundoff); }

// Exact value of row (x, y, z, w), and the sum of the absolute terms, which the rounding errors are relative to.
struct Sum {
  Real value, magnitude;
};

Sum apply(const MatrixRow& row, const Points& points, std::size_t i, float w) {
  const Real terms[] = {Real(row[0]) * points.x[i], Real(row[1]) * points.y[i], Real(row[2]) * points.z[i],
                        Real(row[3]) * w};
  Sum sum{0, 0};
  for (const Real& term : terms) {
    sum.value += term;
    sum.magnitude += abs(term);
  }
  return sum;
}

// Keeps the largest fraction of its bound that an error reached, so that a bound that says nothing is seen.
class Judge {
 public:
  void expect_within(float actual, const Real& expected, const Real& bound, std::size_t element) {
    const Real error = abs(Real(actual) - expected);
    EXPECT_LE(error, bound) << "element " << element << ": actual " << actual << ", expected " << expected;
    if (bound > 0) largest_ = std::max(largest_, Real(error / bound).convert_to<double>());
  }
  ~Judge() { EXPECT_GT(largest_, 0.1) << "the bound is too wide to tell anything"; }

 private:
  double largest_ = 0;
};

void judge_points(const AffineRows& rows, Family family) {
  const Points in = make_points(point_count, family, 11);
  Points out(point_count);
  transform_points(shared_session(), rows, in.arrays(), out.arrays());
  Judge judge;
  for (std::size_t i = 0; i < point_count; ++i) {
    const auto check = [&](const MatrixRow& row, float actual) {
      const Sum exact = apply(row, in, i, 1);
      judge.expect_within(actual, exact.value, gamma(3) * exact.magnitude + 3 * denormal_rounding, i);
    };
    check(rows.x, out.x[i]);
    check(rows.y, out.y[i]);
    check(rows.z, out.z[i]);
  }
}

TEST(TransformPointsAccuracy, BenignCoordinates) { judge_points(general_matrix(), Family::benign); }
TEST(TransformPointsAccuracy, WideRange) { judge_points(general_matrix(), Family::wide); }
TEST(TransformPointsAccuracy, CancellingRows) { judge_points(cancelling_matrix(), Family::cancelling); }

TEST(TransformVectorsAccuracy, ThreeRoundings) {
  const AffineRows rows = general_matrix();
  for (const Family family : {Family::benign, Family::wide}) {
    const Points in = make_points(point_count, family, 12);
    Points out(point_count);
    transform_vectors(shared_session(), rows, in.arrays(), out.arrays());
    Judge judge;
    for (std::size_t i = 0; i < point_count; ++i) {
      const auto check = [&](const MatrixRow& row, float actual) {
        const Sum exact = apply(row, in, i, 0);
        judge.expect_within(actual, exact.value, gamma(3) * exact.magnitude + 3 * denormal_rounding, i);
      };
      check(rows.x, out.x[i]);
      check(rows.y, out.y[i]);
      check(rows.z, out.z[i]);
    }
  }
}

// X/w: both sums carry gamma(3) of their magnitudes, the division one rounding more.
TEST(ProjectPointsAccuracy, SumsAndOneDivision) {
  const ProjectiveRows rows = perspective_matrix();
  const Points in = make_points(point_count, Family::benign, 13);
  Points out(point_count);
  project_points(shared_session(), rows, in.arrays(), out.arrays());
  Judge judge;
  std::size_t judged = 0;
  for (std::size_t i = 0; i < point_count; ++i) {
    const Sum w = apply(rows.w, in, i, 1);
    const Real w_error = gamma(3) * w.magnitude;
    if (w.value <= w_error) continue;  // behind the eye, or too near to tell
    ++judged;
    const auto check = [&](const MatrixRow& row, float actual) {
      const Sum exact = apply(row, in, i, 1);
      const Real quotient = exact.value / w.value;
      const Real before_division = (gamma(3) * exact.magnitude + abs(quotient) * w_error) / (w.value - w_error);
      const Real bound = before_division + unit_roundoff * (abs(quotient) + before_division) + denormal_rounding;
      judge.expect_within(actual, quotient, bound, i);
    };
    check(rows.x, out.x[i]);
    check(rows.y, out.y[i]);
    check(rows.z, out.z[i]);
  }
  EXPECT_GT(judged, point_count / 2);
}

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Vector linear_part(const MatrixRow& row) { return {Real(row[0]), Real(row[1]), Real(row[2])}; }

// Rows of the inverse transpose times a power of two of (largest entry in [1/2, 1)).
std::array<Vector, 3> exact_normal_rows(const AffineRows& rows) {
  const Vector x = linear_part(rows.x), y = linear_part(rows.y), z = linear_part(rows.z);
  std::array<Vector, 3> normals = {cross(y, z), cross(z, x), cross(x, y)};
  const Real determinant = x[0] * normals[0][0] + x[1] * normals[0][1] + x[2] * normals[0][2];
  Real largest = 0;
  for (const Vector& row : normals)
    for (const Real& entry : row) largest = std::max(largest, Real(abs(entry)));
  int exponent = 0;
  frexp(largest, &exponent);
  for (Vector& row : normals)
    for (Real& entry : row) entry = ldexp(determinant < 0 ? -entry : entry, -exponent);
  return normals;
}

const AffineRows matrices[] = {
    general_matrix(),
    {{1e-6f, 3e5f, 1, 0}, {-2e4f, 1.7f, 1e-3f, 0}, {0.3f, 0.7f, -1.1f, 0}},
    // Nearly flat: the cofactors lose most of their places to cancellation unless products are exact.
    {{1.1f, 2.3f, 3.7f, 0}, {1.1000001f, 2.3f, 3.7000003f, 0}, {-0.4f, 0.9f, 2.2f, 0}},
};

TEST(NormalRowsAccuracy, OneRoundingEachEntry) {
  const Real bound = unit_roundoff * (1 + ldexp(Real(1), -28));
  for (const AffineRows& rows : matrices) {
    const AffineRows actual = normal_rows(rows);
    const std::array<Vector, 3> exact = exact_normal_rows(rows);
    const MatrixRow* const actual_rows[] = {&actual.x, &actual.y, &actual.z};
    Judge judge;
    for (std::size_t row = 0; row < 3; ++row)
      for (std::size_t column = 0; column < 3; ++column)
        judge.expect_within((*actual_rows[row])[column], exact[row][column], bound * abs(exact[row][column]),
                            3 * row + column);
  }
}

// v = R n with one rounding in each entry of R and three in each sum: within gamma(4) of the sum of absolute terms. A
// vector off by e times its length points off by at most asin(e) <= e (1 + e) for e <= 1/2. The unit vector of the
// computed v then takes 3 roundings for the squared length, halved by the root, one for the root and one for the
// division: 3.5 u, within gamma(4).
TEST(TransformNormalsAccuracy, SumsAndNormalisation) {
  for (const AffineRows& rows : matrices) {
    const std::array<Vector, 3> exact_rows = exact_normal_rows(rows);
    for (const Family family : {Family::benign, Family::wide}) {
      const Points in = make_points(point_count, family, 14);
      Points out(point_count);
      transform_normals(shared_session(), rows, in.arrays(), out.arrays());
      std::size_t judged = 0;
      for (std::size_t i = 0; i < point_count; ++i) {
        Vector exact{0, 0, 0};
        Real magnitude_squared = 0;
        for (std::size_t row = 0; row < 3; ++row) {
          const Real terms[] = {exact_rows[row][0] * in.x[i], exact_rows[row][1] * in.y[i],
                                exact_rows[row][2] * in.z[i]};
          Real magnitude = 0;
          for (const Real& term : terms) {
            exact[row] += term;
            magnitude += abs(term);
          }
          magnitude_squared += magnitude * magnitude;
        }
        const Real length = sqrt(exact[0] * exact[0] + exact[1] * exact[1] + exact[2] * exact[2]);
        const Real turned = gamma(4) * sqrt(magnitude_squared) / length;
        if (turned > 0.5) continue;  // nothing is left of the direction
        ++judged;
        const float actual[] = {out.x[i], out.y[i], out.z[i]};
        for (std::size_t axis = 0; axis < 3; ++axis) {
          const Real expected = exact[axis] / length;
          const Real bound = turned * (1 + turned) + gamma(4) * (abs(expected) + turned) + denormal_rounding;
          EXPECT_LE(abs(actual[axis] - expected), bound) << "normal " << i << ", axis " << axis;
        }
        const Real squared = Real(actual[0]) * actual[0] + Real(actual[1]) * actual[1] + Real(actual[2]) * actual[2];
        EXPECT_LE(abs(sqrt(squared) - 1), gamma(4)) << "length of normal " << i;
      }
      EXPECT_GT(judged, point_count * 9 / 10);
    }
  }
}

}  // namespace
}  // namespace morphcl
