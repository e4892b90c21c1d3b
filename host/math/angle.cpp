#include "host/math/angle.hpp"

#include <cmath>

#include "host/error.hpp"
#include "host/math/elementary.hpp"

namespace morphcl {

namespace {

// pi/180 and 180/pi as unevaluated sums of two doubles, 106 bits.
constexpr double radians_per_degree = 0x1.1df46a2529d39p-6, radians_per_degree_low = 0x1.5c1d8becdd291p-62;
constexpr double degrees_per_radian = 0x1.ca5dc1a63c1f8p+5, degrees_per_radian_low = -0x1.1e7ab456405f9p-49;

// Sine and cosine of an angle in [-45, 45] degrees.
SinCos first_octants(double angle) {
  const double x = angle * radians_per_degree;
  const double x_low = std::fma(angle, radians_per_degree, -x) + angle * radians_per_degree_low;
  const double z = x * x;
  const double z_low = std::fma(x, x, -z);

  const double sine_rest = std::fma(x * z, sine_tail(z), x_low * std::fma(-0.5, z, 1.0));

  const double head = 1 - 0.5 * z;
  const double head_low = (1 - head) - 0.5 * z;
  const double cosine_rest = std::fma(z * z, cosine_tail(z), -std::fma(x, x_low, 0.5 * z_low));
  return {x + sine_rest, head + (head_low + cosine_rest)};
}

}  // namespace

SinCos sin_cos_degrees(double degrees) {
  if (!std::isfinite(degrees)) throw Error(ErrorKind::usage, "", "an angle is not a finite number; give it in degrees");
  int quarter_turns = 0;
  const double rest = std::remquo(degrees, 90.0, &quarter_turns);
  const SinCos turned = first_octants(rest);
  // Adding 0 turns -0 into +0, so that equal rotations have equal bits.
  switch (quarter_turns & 3) {
    case 0:
      return {turned.sin + 0.0, turned.cos + 0.0};
    case 1:
      return {turned.cos + 0.0, -turned.sin + 0.0};
    case 2:
      return {-turned.sin + 0.0, -turned.cos + 0.0};
    default:
      return {-turned.cos + 0.0, turned.sin + 0.0};
  }
}

double radians(double degrees) { return std::fma(degrees, radians_per_degree, degrees * radians_per_degree_low); }

double degrees(double radians) { return std::fma(radians, degrees_per_radian, radians * degrees_per_radian_low); }

}  // namespace morphcl
