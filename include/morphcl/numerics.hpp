// Numbers: angles, elementary functions, interpolation, rounded storage and exact predicates, with stated errors, the
// same bits on every machine.
#pragma once

#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>

#pragma GCC visibility push(default)
namespace morphcl {

// ---- angle ----------------------------------------------------------------------------------------------------------
//
// Sine and cosine of an angle in degrees, correctly rounded: exact wherever they are rational (multiples of 90; 0.5 at
// 30 and 60) and with sin = cos at 45. The one reduction modulo 360 is exact, so that 1e15 + 30 degrees is as good
// as 30. Results that are 0 are +0.

struct SinCos {
  double sin, cos;
};

// Error(usage) for a NaN or infinite angle.
SinCos sin_cos_degrees(double degrees);

// Conversions: the nearest double, or the one beside it.
double radians(double degrees);
double degrees(double radians);

// ---- trigonometry ---------------------------------------------------------------------------------------------------
//
// Sine, cosine, tangent and arc tangent in radians, correctly rounded: the double nearest to the exact value for the
// given doubles, so the same bits on every machine. (The C library's differ from version to version and from processor
// to processor.)
//
// Method: Ziv (1991). A first phase of about 70 bits decides nearly always; where its error bound leaves two doubles
// possible, a second one of more than 180 bits in integers decides. Arguments of any size are reduced exactly. The
// hardest arguments published need some 53 + 70 bits; that none needs 180 is not proved for sine, cosine and tangent of
// large numbers and for the arc tangent, but the chance that one of them does is below 2^-50.
//
// Compared with MPFR: 20 million arguments each of sine, cosine, tangent and of the
// arc tangents of x / 1, 1 / x and x / -3, one million each of sine and cosine of degrees; no miss.
//
// Special values are those that IEEE 754 recommends: NaN for infinite angles, -0 for -0, and for the arc tangent the
// sign of y and the half-plane of x, zeros and infinities included.

double sine(double x);
double cosine(double x);
double tangent(double x);

// The angle of the vector (x, y) in [-pi, pi].
double arc_tangent(double y, double x);

// ---- exponential ----------------------------------------------------------------------------------------------------
//
// The exponential function, correctly rounded: the double nearest to the exact value, so the same bits on every
// machine.
//
// Method: Ziv's two phases as above. x = k ln 2 + r with |r| <= 0.35, r in double-double arithmetic;
// e^(r/8) - 1 by its Taylor series, squared three times as s (s + 2), within 2^-67 relative; where that leaves two
// doubles possible, the series of e^r in 256-bit integers. The hardest argument is known to need 53 + 60 bits (Lefevre
// and Muller 2001), but for those below 2^-30, whose hardness is that of 1 + x + x^2/2; at most some 53 + 110.
// Compared with MPFR at 20 million arguments each of both functions: no miss.
//
// Special values: e^-inf = 0, e^inf = inf, NaN for NaN; exponential_minus_1(-0) = -0, and -1 for -inf. Results too
// large are infinite, those too small subnormal or 0.

double exponential(double x);          // e^x
double exponential_minus_1(double x);  // e^x - 1, also where x is small

// ---- lerp -----------------------------------------------------------------------------------------------------------
//
// Linear interpolation that keeps its ends.
//
// Exact at t = 0, at t = 1 and where a equals b; never overflows for t in [0, 1]. Error at most 1 ulp when a and b have
// the same sign, else half an ulp of the result plus u |a|. The forms a + t (b - a) and (1 - t) a + t b keep none of
// the three.

// (1 - t) a + t b. T is float or double.
template <typename T>
T lerp(T a, T b, T t) {
  return std::fma(t, b, std::fma(-t, a, a));
}

// ---- perspective lerp -----------------------------------------------------------------------------------------------
//
// Attributes along the picture of an edge: linear in space, not in the picture.
//
// Weights of both ends are formed as products, t and 1 - t apart, so that no end is lost however much the distances
// differ: at most 3.1 ulp for attributes of the same sign, else 5u max |a|; exact at t = 0 and t = 1. The form
// p + t (q - p) of the reciprocals loses 1e6 ulp at a ratio of distances of 1e6.

// The attribute where the picture of the edge is divided 1 - t to t; a1, a2 at the ends, w1, w2 > 0 their distances
// (clip-space w), t in [0, 1]. T is float or double.
template <typename T>
T perspective_lerp(T a1, T w1, T a2, T w2, T t) {
  if (t == 0) return a1;
  if (t == 1) return a2;
  const T first = w2 * (1 - t), second = w1 * t;
  return std::fma(a1, first, a2 * second) / (first + second);
}

// ---- half storage ---------------------------------------------------------------------------------------------------
//
// Numbers stored in 16 bits: as halves, and as halves about the middle of their range.
//
// A double is rounded to the half directly, to nearest, ties to even: by way of fp32 it would be rounded twice, and
// 1 + 2^-11 + 2^-40 come out as 1 instead of 1 + 2^-10.

// The bits of the nearest half; infinity from 65520 on, NaN for NaN.
std::uint16_t to_half(double value);
double from_half(std::uint16_t bits);  // exact

// value = bias + scale * half. Halves are spaced by 0.5 at 1000, so coordinates far from the origin are stored about
// the middle of their range: the error is at most 2^-12 of `scale`, which is less than twice half the range.
struct HalfRange {
  double bias = 0;
  double scale = 1;  // a power of two that brings all values into [-1, 1]

  std::uint16_t store(double value) const { return to_half((value - bias) / scale); }
  double load(std::uint16_t bits) const { return bias + scale * from_half(bits); }
};

// The range of finite values; of none, {0, 1}.
HalfRange half_range(std::span<const double> values);

// ---- fewer mantissa bits --------------------------------------------------------------------------------------------
//
// binary32 with zeros at the end of its mantissa, for files that are compressed. With m of the 23 bits kept, a value
// that is rounded to nearest moves by u / (1 + u) of itself at most, u = 2^-(m + 1): the worst one lies u above a power
// of two, halfway between two that are kept. (Jeannerod and Rump 2018, "On relative errors of floating-point
// operations", has the bound.)

constexpr int float_mantissa_bits = 23;
constexpr double max_relative_error = 0.1;

// The fewest bits for which u / (1 + u) <= relative_error, exactly decided; 23 where no rounding keeps it. Error(usage)
// unless 0 < relative_error <= max_relative_error.
int mantissa_bits_for(double relative_error);

// The largest power of two of whose multiples the nearest is within `absolute_error` of any number. Error(usage) unless
// 0 < absolute_error <= max_absolute_error.
constexpr double max_absolute_error = 0.1;
double step_for(double absolute_error);

// Rounds each value to `bits` (0 to 23) of its mantissa, to nearest, ties to even. Zeros, infinities, NaN and `kept`
// stay as they are; so do denormals, which have fewer bits, and what would round to infinity.
void round_mantissas(std::span<float> values, int bits, float kept = 0);

// ---- orientation ----------------------------------------------------------------------------------------------------
//
// On which side a point lies: signs of determinants, exact for the numbers given.
//
// Method: Shewchuk (1997). A floating-point evaluation decides where it is further from 0 than its error bound;
// otherwise all products are formed without rounding and summed as an expansion, whose leading component has the sign
// of the sum; where a product might overflow or underflow, beyond 1e90 or below 1e-90, as an integer of any length.
// Error(usage) for a coordinate that is not finite.

// 1: counter-clockwise, c lies to the left of the line from a to b; -1: to the right; 0: exactly on it.
int orientation(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c);
int orientation(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) = delete;  // GLM would drop z

// 1: d lies on the side of the plane through a, b, c from which they are seen counter-clockwise; -1: on the other;
// 0: exactly in it, or the three have no plane.
int orientation(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d);

// ---- point in polygon -----------------------------------------------------------------------------------------------
//
// Whether a point lies in a polygon of the plane: exactly, for the coordinates given.
//
// Method: the winding number, counted over edges that are half-open in y, with the exact orientations above; so an edge
// or corner that two polygons share is never counted twice, and no angles are added. A point on the boundary is an
// answer of its own.

enum class PointPlace { outside, inside, boundary };

// The polygon is closed by an edge from its last corner to its first; it may be concave, cross itself or run clockwise.
// Inside is where it winds around the point other than 0 times. Of no corners nothing is inside.
PointPlace place_in_polygon(std::span<const glm::dvec2> polygon, const glm::dvec2& point);

// How many times the polygon runs around a point that is not on its boundary, counter-clockwise counted positive. On
// its boundary: some number.
int winding_number(std::span<const glm::dvec2> polygon, const glm::dvec2& point);

}  // namespace morphcl
#pragma GCC visibility pop
