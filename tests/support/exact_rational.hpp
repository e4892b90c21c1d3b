// The judge of geometric predicates: rational numbers of Boost, in vectors, and doubles that are hard on predicates.
#pragma once

#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdlib>
#include <glm/glm.hpp>
#include <limits>

#include "tests/support/random.hpp"

namespace morphcl::test_support {

using Rational = boost::multiprecision::cpp_rational;

constexpr double double_infinity = std::numeric_limits<double>::infinity();
constexpr double double_nan = std::numeric_limits<double>::quiet_NaN();

// The quotient of its mantissa and a power of 2. (Boost's own conversion is not meant for subnormal numbers.)
inline Rational rational(double value) {
  using boost::multiprecision::cpp_int;
  int exponent = 0;
  const auto mantissa = static_cast<long long>(std::ldexp(std::frexp(value, &exponent), 53));
  exponent -= 53;
  if (exponent >= 0) return Rational(cpp_int(mantissa) << exponent);
  return Rational(cpp_int(mantissa), cpp_int(1) << -exponent);
}

struct RationalVector {
  Rational x, y, z;
};

inline RationalVector rational(const glm::dvec3& v) { return {rational(v.x), rational(v.y), rational(v.z)}; }
inline RationalVector operator-(const RationalVector& a, const RationalVector& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline RationalVector operator+(const RationalVector& a, const RationalVector& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline RationalVector operator*(const Rational& s, const RationalVector& a) { return {s * a.x, s * a.y, s * a.z}; }
inline Rational dot(const RationalVector& a, const RationalVector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline RationalVector cross(const RationalVector& a, const RationalVector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline int sign_of(const Rational& value) { return value > 0 ? 1 : value < 0 ? -1 : 0; }

// Whether `value` is the double nearest to `exact`, ties to even; both within the range of normal numbers or 0.
inline bool is_nearest(double value, const Rational& exact) {
  const double above = std::nextafter(value, double_infinity), below = std::nextafter(value, -double_infinity);
  const Rational error = abs(rational(value) - exact);
  int exponent = 0;
  const bool even = (static_cast<long long>(std::ldexp(std::frexp(value, &exponent), 53)) & 1) == 0;
  for (const double other : {above, below}) {
    if (!std::isfinite(other)) continue;
    const Rational distance = abs(rational(other) - exact);
    if (distance < error || (distance == error && !even)) return false;
  }
  return true;
}

// Families of coordinates: small whole numbers, which meet in corners, edges and planes all the time; plain ones; ones
// next to whole numbers; sizes from 1e-300 to 1e300 in one object.
enum class Family { whole, plain, nearly_whole, any_size };
constexpr std::array<Family, 4> families = {Family::whole, Family::plain, Family::nearly_whole, Family::any_size};

// Rationals of coordinates of any size are thousands of bits long. MORPHCL_LONG_TESTS: a hundred times as many.
inline int cases(Family family) {
  return (family == Family::any_size ? 150 : 1500) * (std::getenv("MORPHCL_LONG_TESTS") != nullptr ? 100 : 1);
}

inline double coordinate(Random& random, Family family) {
  switch (family) {
    case Family::whole:
      return static_cast<double>(random.integer_in(-2, 2));
    case Family::plain:
      return random.in(-1, 1);
    case Family::nearly_whole: {
      const double whole = static_cast<double>(random.integer_in(-1, 1));
      const long long way = random.integer_in(-2, 2);
      return way == 1 ? std::nextafter(whole, 9.0) : way == -1 ? std::nextafter(whole, -9.0) : whole;
    }
    case Family::any_size:
      break;
  }
  const double fraction = random.in(1, 2);
  const int exponent = static_cast<int>(random.integer_in(-1, 1)) * 996;
  const long long sign = random.integer_in(-1, 1);
  return static_cast<double>(sign) * std::ldexp(random.integer_in(0, 1) == 0 ? 1 : fraction, exponent);
}

inline glm::dvec2 point2(Random& random, Family family) {
  const double x = coordinate(random, family), y = coordinate(random, family);
  return {x, y};
}

inline glm::dvec3 point3(Random& random, Family family) {
  const double x = coordinate(random, family), y = coordinate(random, family), z = coordinate(random, family);
  return {x, y, z};
}

}  // namespace morphcl::test_support
