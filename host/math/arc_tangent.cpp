#include <cmath>
#include <limits>

#include "host/math/accurate_sine.hpp"
#include "host/math/circle_constants.hpp"
#include "host/math/double_double.hpp"
#include "host/math/sine_kernel.hpp"
#include "morphcl/numerics.hpp"

namespace morphcl {

namespace {

constexpr double arc_tangent_error = 4 * sine_kernel_error;

// atan(t) for t in [0, 1] within 2^-48 relative. Halved twice, tan(a/2) = t / (1 + sqrt(1 + t^2)), then the Taylor
// series: 0.199^28 / 29 is below 2^-69.
MORPHCL_INLINED double approximate_arc_tangent(double t) {
  for (int halving = 0; halving < 2; ++halving) t /= 1 + std::sqrt(std::fma(t, t, 1.0));
  constexpr int terms = 14;
  const double z = t * t;
  double sum = 0;
  for (int k = terms - 1; k > 0; --k) sum = std::fma(-z, sum, 1.0 / (2 * k + 1));
  return 4 * std::fma(-t * z, sum, t);
}

// atan(y / x) for 0 < y <= x, both of moderate size: an approximation a and one step of Newton's method,
// atan(y/x) - a = atan((y cos a - x sin a) / (x cos a + y sin a)), whose arc tangent is its argument within 2^-100.
MORPHCL_INLINED DoubleDouble fast_arc_tangent(double y, double x) {
  const double a = approximate_arc_tangent(y / x);
  const DoubleDouble sin = sine_kernel({a, 0}), cos = cosine_kernel({a, 0});
  const DoubleDouble across = cos * y - sin * x;
  return fast_two_sum(a, across.high / std::fma(cos.high, x, sin.high * y));
}

// 1 - z/3 + z^2/5 - z^3/7 + z^4/9, for z < 2^-53.
Fixed256 arc_tangent_series(const Fixed256& z) {
  Fixed256 sum = fixed_one / 9;
  for (const unsigned divisor : {7u, 5u, 3u, 1u}) sum = fixed_one / divisor - z * sum;
  return sum;
}

// The same for y / x below 2^-30: t - t^3/3 + ..., where the quotient's remainder decides nothing but that the arc
// tangent is less than the quotient, which matters where the quotient lies half-way between two subnormal doubles.
Float256 accurate_small_arc_tangent(const Float256& y, const Float256& x) {
  const Float256 t = y / x;
  const Fixed256 factor = arc_tangent_series(to_fixed_256(t * t));
  constexpr Fixed256 below_one{{~std::uint64_t{0}, ~std::uint64_t{0}, ~std::uint64_t{0}, ~std::uint64_t{0}, 0}};
  return t * to_float_256(factor < fixed_one ? factor : below_one);
}

// As fast_arc_tangent(), within 2^-215 relative; x is in [1/2, 1).
Float256 accurate_arc_tangent(const Float256& y, const Float256& x) {
  if (y.exponent < -30) return accurate_small_arc_tangent(y, x);
  const Float256 a = to_float_256(approximate_arc_tangent(to_double(y) / to_double(x)));
  const Fixed256 sin = to_fixed_256(accurate_sine(a)), cos = accurate_cosine(a);
  const Fixed256 fixed_y = to_fixed_256(y), fixed_x = to_fixed_256(x);
  const Fixed256 high = fixed_y * cos, low = fixed_x * sin, along = fixed_x * cos + fixed_y * sin;
  const bool above = !(high < low);
  const Fixed256 t = (above ? high - low : low - high) / along;
  const Fixed256 step = t * arc_tangent_series(t * t);
  const Fixed256 start = to_fixed_256(a);
  return to_float_256(above ? start + step : start - step);
}

// Which arc tangent of the quotient of the smaller by the larger the angle is made of.
struct Octant {
  bool swapped;  // pi/2 minus it
  bool turned;   // pi minus that
};

MORPHCL_INLINED DoubleDouble fast_in_octant(DoubleDouble angle, Octant octant) {
  if (octant.swapped) angle = half_pi_double_double - angle;
  if (octant.turned) angle = pi_double_double - angle;
  return angle;
}

Float256 accurate_in_octant(const Float256& angle, Octant octant) {
  if (!octant.swapped && !octant.turned) return angle;
  Fixed256 fixed = to_fixed_256(angle);
  if (octant.swapped) fixed = half_pi_fixed - fixed;
  if (octant.turned) fixed = pi_fixed - fixed;
  return to_float_256(fixed);
}

// For zeros and infinities; y >= 0.
double special_arc_tangent(double y, double x, bool turned) {
  constexpr double pi = pi_double_double.high, half_pi = half_pi_double_double.high;
  // 3 pi / 4 correctly rounded; pi/4 and pi/2 are halves of pi.
  constexpr double three_quarter_pi = 0x1.2d97c7f3321d2p+1;
  if (std::isinf(x) && std::isinf(y)) return turned ? three_quarter_pi : 0.5 * half_pi;
  if (y == 0 || std::isinf(x)) return turned ? pi : 0;
  return half_pi;
}

// x and y are positive and finite.
MORPHCL_INLINED double angle_in_half_plane(double y, double x, bool turned) {
  const Octant octant{y > x, turned};
  int exponent = 0, small_exponent = 0;
  const double large = std::frexp(octant.swapped ? y : x, &exponent);
  const double small = std::frexp(octant.swapped ? x : y, &small_exponent);
  small_exponent -= exponent;
  // Quotients beyond this may be subnormal, or too small to be told from 0 in fp64.
  constexpr int min_exponent = -900;
  if (small_exponent > min_exponent) {
    const DoubleDouble angle = fast_arc_tangent(std::ldexp(small, small_exponent), large);
    if (const auto fast = rounded(fast_in_octant(angle, octant), arc_tangent_error)) return *fast;
  }
  Float256 numerator = to_float_256(small);
  numerator.exponent += small_exponent;
  return to_double(accurate_in_octant(accurate_arc_tangent(numerator, to_float_256(large)), octant));
}

}  // namespace

MORPHCL_WITH_HARDWARE_FMA double arc_tangent(double y, double x) {
  if (std::isnan(x) || std::isnan(y)) return std::numeric_limits<double>::quiet_NaN();
  const double height = std::abs(y), width = std::abs(x);
  const bool turned = std::signbit(x);
  const bool special = height == 0 || width == 0 || std::isinf(height) || std::isinf(width);
  const double angle =
      special ? special_arc_tangent(height, width, turned) : angle_in_half_plane(height, width, turned);
  return std::signbit(y) ? -angle : angle;
}

}  // namespace morphcl
