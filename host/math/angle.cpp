#include "morphcl/numerics.hpp"

#include <cmath>

#include "host/math/accurate_sine.hpp"
#include "host/math/circle_constants.hpp"
#include "host/math/sine_kernel.hpp"
#include "morphcl/error.hpp"

namespace morphcl {

namespace {

// 180/pi as an unevaluated sum of two doubles.
constexpr double degrees_per_radian = 0x1.ca5dc1a63c1f8p+5, degrees_per_radian_low = -0x1.1e7ab456405f9p-49;

// The kernel's, with the conversion to radians and the rounding test's own roundings.
constexpr double octant_error = 2 * sine_kernel_error;

Float256 accurate_radians(double degrees) { return to_float_256(degrees) * radians_per_degree_float; }

// Of an angle in [0, 45] degrees.
MORPHCL_INLINED double sine_of_octant(double degrees, const DoubleDouble& r) {
  constexpr double min_degrees = 0x1p-900;  // below it the low parts of the fast phase may be lost
  if (degrees >= min_degrees)
    if (const auto fast = rounded(sine_kernel(r), octant_error)) return *fast;
  return to_double(accurate_sine(accurate_radians(degrees)));
}

MORPHCL_INLINED double cosine_of_octant(double degrees, const DoubleDouble& r) {
  if (const auto fast = rounded(cosine_kernel(r), octant_error)) return *fast;
  return to_double(to_float_256(accurate_cosine(accurate_radians(degrees))));
}

// Of a finite number.
MORPHCL_WITH_HARDWARE_FMA SinCos sin_cos_of_degrees(double degrees) {
  int quarter_turns = 0;
  const double rest = std::remquo(degrees, 90.0, &quarter_turns), size = std::abs(rest);
  const DoubleDouble r = radians_per_degree_double_double * size;
  const double sin = size == 0 ? 0 : std::copysign(sine_of_octant(size, r), rest), cos = cosine_of_octant(size, r);
  // Adding 0 turns -0 into +0, so that equal rotations have equal bits.
  switch (quarter_turns & 3) {
    case 0:
      return {sin + 0.0, cos};
    case 1:
      return {cos, -sin + 0.0};
    case 2:
      return {-sin + 0.0, -cos};
    default:
      return {-cos, sin + 0.0};
  }
}

}  // namespace

SinCos sin_cos_degrees(double degrees) {
  if (!std::isfinite(degrees)) throw Error(ErrorKind::usage, "", "an angle is not a finite number; give it in degrees");
  return sin_cos_of_degrees(degrees);
}

double radians(double degrees) {
  return std::fma(degrees, radians_per_degree_double_double.high, degrees * radians_per_degree_double_double.low);
}

double degrees(double radians) { return std::fma(radians, degrees_per_radian, radians * degrees_per_radian_low); }

}  // namespace morphcl
