#include "host/math/elementary.hpp"

#include <array>
#include <cmath>
#include <cstddef>

namespace morphcl {

namespace {

constexpr std::size_t tail_terms = 11;
constexpr double half_pi_high = 0x1.921fb54442d18p+0, half_pi_low = 0x1.1a62633145c07p-54;

// Coefficients (-1)^k / (2k + first)! with k counted from the first one kept; the sign starts at `sign`.
constexpr std::array<double, tail_terms> reciprocal_factorials(int first, double sign) {
  std::array<double, tail_terms> coefficients{};
  double factorial = 1;
  for (int n = 2; n <= first; ++n) factorial *= n;
  for (std::size_t k = 0; k < tail_terms; ++k) {
    coefficients[k] = sign / factorial;
    const int n = first + 2 * static_cast<int>(k);
    factorial *= static_cast<double>((n + 1) * (n + 2));
    sign = -sign;
  }
  return coefficients;
}

template <std::size_t N>
double horner(const std::array<double, N>& coefficients, double z) {
  double sum = coefficients[N - 1];
  for (std::size_t k = N - 1; k-- > 0;) sum = std::fma(sum, z, coefficients[k]);
  return sum;
}

// atan(t) for 0 <= t <= tan(pi/16): sum of (-1)^k t^(2k+1) / (2k+1); 0.0396^14 / 29 is below 2^-60.
double small_arc_tangent(double t) {
  constexpr int terms = 14;
  const double z = t * t;
  double sum = 0;
  for (int k = terms - 1; k > 0; --k) sum = std::fma(-z, sum, 1.0 / (2 * k + 1));
  return std::fma(-t * z, sum, t);
}

// atan(t) for 0 <= t <= 1.
double arc_tangent(double t) {
  for (int halving = 0; halving < 2; ++halving) t /= 1 + std::sqrt(std::fma(t, t, 1.0));
  return 4 * small_arc_tangent(t);
}

}  // namespace

double sine_tail(double z) {
  static constexpr auto coefficients = reciprocal_factorials(3, -1);
  return horner(coefficients, z);
}

double cosine_tail(double z) {
  static constexpr auto coefficients = reciprocal_factorials(4, 1);
  return horner(coefficients, z);
}

double sinc(double x) {
  const double z = x * x;
  return std::fma(z, sine_tail(z), 1.0);
}

double quadrant_angle(double y, double x) {
  if (y <= x) return arc_tangent(y / x);
  return half_pi_high + (half_pi_low - arc_tangent(x / y));
}

}  // namespace morphcl
