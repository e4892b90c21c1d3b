#include "tests/math/reference.hpp"

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <cmath>

#include "tests/math/reference_real.hpp"

namespace morphcl::reference {

namespace {

using Matrix = std::array<std::array<Real, 4>, 4>;

const Real pi = boost::math::constants::pi<Real>();

Affine exact_rows(const Matrix& m) {
  Affine rows;
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 4; ++c) rows[r][c] = exact(m[r][c]);
  return rows;
}

// degrees modulo 360 in integers: mantissa * 2^exponent, the power reduced step by step.
Real reduced(double degrees) {
  int exponent = 0;
  const auto mantissa = static_cast<long long>(std::ldexp(std::frexp(degrees, &exponent), 53));
  exponent -= 53;
  if (exponent <= 0) return ldexp(Real(mantissa % (360ll << std::min(-exponent, 54))), exponent);
  long long rest = mantissa % 360;
  for (; exponent > 0; --exponent) rest = 2 * rest % 360;
  return rest;
}

Vector vector(const glm::dvec3& v) { return {v.x, v.y, v.z}; }
Vector minus(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Vector unit(const Vector& a) {
  const Real length = sqrt(dot(a, a));
  return {a[0] / length, a[1] / length, a[2] / length};
}

Matrix identity() {
  Matrix m;
  for (int r = 0; r < 4; ++r)
    for (int c = 0; c < 4; ++c) m[r][c] = r == c ? 1 : 0;
  return m;
}

Matrix matrix(const glm::dmat4& m) {
  Matrix rows;
  for (int r = 0; r < 4; ++r)
    for (int c = 0; c < 4; ++c) rows[r][c] = m[c][r];
  return rows;
}

Matrix times(const Matrix& a, const Matrix& b) {
  Matrix m;
  for (int r = 0; r < 4; ++r)
    for (int c = 0; c < 4; ++c) {
      m[r][c] = 0;
      for (int k = 0; k < 4; ++k) m[r][c] += a[r][k] * b[k][c];
    }
  return m;
}

std::array<Real, 4> unit(const Quaternion& q) {
  const Real x = q[0], y = q[1], z = q[2], w = q[3];
  const Real length = sqrt(Real(x * x + y * y + z * z + w * w));
  return {x / length, y / length, z / length, w / length};
}

Real cosine_between(const std::array<Real, 4>& a, const std::array<Real, 4>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
}

}  // namespace

double error_in_ulp(double computed, const Exact& exact) {
  int exponent = 0;
  std::frexp(exact.high, &exponent);
  return exact.error_of(computed) / std::ldexp(1.0, exponent - 53);
}

ExactSinCos sin_cos_degrees(double degrees) {
  const Real angle = reduced(degrees) * pi / 180;
  return {exact(sin(angle)), exact(cos(angle))};
}

Exact radians(double degrees) { return exact(Real(degrees) * pi / 180); }
Exact degrees(double radians) { return exact(Real(radians) * 180 / pi); }

Exact decimal(const std::string& digits) {
  const auto slash = digits.find('/');
  if (slash == std::string::npos) return exact(Real(digits));
  return exact(Real(Real(digits.substr(0, slash)) / Real(digits.substr(slash + 1))));
}

Affine rotation_about_line(const glm::dvec3& from, const glm::dvec3& to, double degrees) {
  const Vector point = vector(from), n = unit(minus(vector(to), point));
  const Real angle = reduced(degrees) * pi / 180;
  const Real c = cos(angle), s = sin(angle);
  Matrix m = identity();
  for (int r = 0; r < 3; ++r)
    for (int k = 0; k < 3; ++k) m[r][k] = (1 - c) * n[r] * n[k] + (r == k ? c : Real(0));
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    m[j][i] += s * n[k];
    m[i][j] -= s * n[k];
  }
  for (int r = 0; r < 3; ++r) m[r][3] = point[r] - (m[r][0] * point[0] + m[r][1] * point[1] + m[r][2] * point[2]);
  return exact_rows(m);
}

Affine look_at(const glm::dvec3& eye, const glm::dvec3& target, const glm::dvec3& up) {
  const Vector position = vector(eye), z = unit(minus(position, vector(target)));
  const Vector x = unit(cross(vector(up), z)), y = cross(z, x);
  const std::array<Vector, 3> axes{x, y, z};
  Matrix m = identity();
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) m[r][c] = axes[r][c];
    m[r][3] = -dot(axes[r], position);
  }
  return exact_rows(m);
}

Affine inverse(const glm::dmat4& affine) {
  const Matrix m = matrix(affine);
  std::array<Vector, 3> columns;
  for (int c = 0; c < 3; ++c) columns[c] = {m[0][c], m[1][c], m[2][c]};
  const Real determinant = dot(columns[0], cross(columns[1], columns[2]));
  Matrix inverted = identity();
  for (int r = 0; r < 3; ++r) {
    const Vector cofactors = cross(columns[(r + 1) % 3], columns[(r + 2) % 3]);
    for (int c = 0; c < 3; ++c) inverted[r][c] = cofactors[c] / determinant;
    inverted[r][3] = 0;
    for (int c = 0; c < 3; ++c) inverted[r][3] -= inverted[r][c] * m[c][3];
  }
  return exact_rows(inverted);
}

Affine product(const std::vector<glm::dmat4>& factors) {
  Matrix m = identity();
  for (const glm::dmat4& factor : factors) m = times(matrix(factor), m);
  return exact_rows(m);
}

Exact difference_of_products(double a, double b, double c, double d) {
  return exact(Real(Real(a) * Real(b) - Real(c) * Real(d)));
}

PerspectiveEntries frustum(double left, double right, double near, double far) {
  const Real l = left, r = right, n = near, f = far;
  return {exact(Real(2 * n / (r - l))), exact(Real((r + l) / (r - l))), exact(Real(-(f + n) / (f - n))),
          exact(Real(-2 * f * n / (f - n)))};
}

Exact cotangent_of_half(double degrees) {
  const Real half = Real(degrees) * pi / 360;
  return exact(Real(cos(half) / sin(half)));
}

Exact fovy_from_fovx(double fovx_degrees, double aspect) {
  return exact(Real(atan(Real(tan(Real(Real(fovx_degrees) * pi / 360)) / Real(aspect))) * 360 / pi));
}

std::array<Exact, 4> slerp(const Quaternion& a, const Quaternion& b, double t) {
  const auto from = unit(a);
  auto to = unit(b);
  if (cosine_between(from, to) < 0)
    for (Real& component : to) component = -component;
  Real cosine = cosine_between(from, to);
  if (cosine > 1) cosine = 1;
  const Real angle = acos(cosine);
  std::array<Exact, 4> result;
  for (int i = 0; i < 4; ++i) {
    const Real straight = from[i] + Real(t) * (to[i] - from[i]);
    // Below 1e-12 radians the arc is straight to 24 digits, and the arc cosine has lost half of its own.
    result[i] = angle < Real("1e-12")
                    ? exact(straight)
                    : exact(Real((sin(Real((1 - Real(t)) * angle)) * from[i] + sin(Real(Real(t) * angle)) * to[i]) /
                                 sin(angle)));
  }
  return result;
}

Exact angle_between(const Quaternion& a, const Quaternion& b) {
  const auto from = unit(a), to = unit(b);
  // |from wedge to| over |from . to|: no cancellation even for nearly equal ones.
  Real wedge = 0;
  for (int i = 0; i < 4; ++i)
    for (int k = i + 1; k < 4; ++k) {
      const Real part = from[i] * to[k] - from[k] * to[i];
      wedge += part * part;
    }
  return exact(atan2(Real(sqrt(wedge)), Real(abs(cosine_between(from, to)))));
}

std::array<std::array<Exact, 3>, 3> rotation_matrix(const Quaternion& q) {
  const auto [x, y, z, w] = unit(q);
  return {{{exact(Real(1 - 2 * (y * y + z * z))), exact(Real(2 * (x * y - w * z))), exact(Real(2 * (x * z + w * y)))},
           {exact(Real(2 * (x * y + w * z))), exact(Real(1 - 2 * (x * x + z * z))), exact(Real(2 * (y * z - w * x)))},
           {exact(Real(2 * (x * z - w * y))), exact(Real(2 * (y * z + w * x))), exact(Real(1 - 2 * (x * x + y * y)))}}};
}

Exact hermite(double a, double out_tangent, double b, double in_tangent, long long position, long long ticks,
              long long ticks_per_second) {
  const Real u = Real(position) / Real(ticks), seconds = Real(ticks) / Real(ticks_per_second);
  const Real u2 = u * u, u3 = u2 * u;
  return exact(Real((2 * u3 - 3 * u2 + 1) * a + seconds * (u3 - 2 * u2 + u) * out_tangent + (3 * u2 - 2 * u3) * b +
                    seconds * (u3 - u2) * in_tangent));
}

}  // namespace morphcl::reference
