#include "tests/anim/spring_reference.hpp"

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cstddef>

namespace morphcl::reference {

namespace {

using Real = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<300>, boost::multiprecision::et_off>;
constexpr std::size_t size = 6;
using Matrix = std::array<std::array<Real, size>, size>;

Matrix product(const Matrix& a, const Matrix& b) {
  Matrix c{};
  for (std::size_t i = 0; i < size; ++i)
    for (std::size_t k = 0; k < size; ++k)
      if (a[i][k] != 0)
        for (std::size_t j = 0; j < size; ++j) c[i][j] += a[i][k] * b[k][j];
  return c;
}

Matrix exponential_of(Matrix m) {
  Real norm = 0;
  for (const auto& row : m) {
    Real sum = 0;
    for (const Real& entry : row) sum += abs(entry);
    if (sum > norm) norm = sum;
  }
  int halvings = 0;
  for (; norm > Real(1) / 1024; norm /= 2) ++halvings;
  const Real scale = ldexp(Real(1), -halvings);
  for (auto& row : m)
    for (Real& entry : row) entry *= scale;
  // exp(m) - 1, so that what is small next to 1 keeps its digits; 90 terms of (1/1024)^n / n! are below 10^-400.
  Matrix sum = m, term = m;
  for (int n = 2; n <= 90; ++n) {
    term = product(term, m);
    for (std::size_t i = 0; i < size; ++i)
      for (std::size_t j = 0; j < size; ++j) {
        term[i][j] /= n;
        sum[i][j] += term[i][j];
      }
  }
  for (; halvings > 0; --halvings) {
    const Matrix square = product(sum, sum);
    for (std::size_t i = 0; i < size; ++i)
      for (std::size_t j = 0; j < size; ++j) sum[i][j] = 2 * sum[i][j] + square[i][j];
  }
  for (std::size_t i = 0; i < size; ++i) sum[i][i] += 1;
  return sum;
}

Exact to_exact(const Real& value) {
  const double high = value.convert_to<double>();
  return {high, (value - Real(high)).convert_to<double>()};
}

}  // namespace

ExactState spring_state(const Spring& spring, const SpringState& from, const Cubic& target, double seconds) {
  const Real omega = spring.angular_frequency, zeta = spring.damping_ratio, t = seconds;
  // Time in units of `seconds`: u = x, w = v t.
  const Real stiffness = omega * omega * t * t, damping = 2 * zeta * omega * t;
  Matrix m{};
  m[0][1] = 1;
  m[1][0] = -stiffness;
  m[1][1] = -damping;
  Real power = 1;
  for (std::size_t i = 0; i < 4; ++i) {
    m[1][2 + i] = stiffness * Real(target[i]) * power;
    power *= t;
    if (i > 0) m[2 + i][1 + i] = static_cast<int>(i);
  }
  const Matrix e = exponential_of(m);
  const std::array<Real, size> start = {
      Real(from.position), Real(from.velocity) * t, Real(1), Real(0), Real(0), Real(0)};
  Real position = 0, velocity = 0;
  for (std::size_t j = 0; j < size; ++j) {
    position += e[0][j] * start[j];
    velocity += e[1][j] * start[j];
  }
  return {to_exact(position), to_exact(velocity / t)};
}

}  // namespace morphcl::reference
