// Sine and cosine of an angle in degrees, correctly rounded: exact wherever they are rational (multiples of 90; 0.5 at
// 30 and 60) and with sin = cos at 45. The one reduction modulo 360 is exact, so that 1e15 + 30 degrees is as good
// as 30. Method and limits of the proof: host/math/trigonometry.hpp. Results that are 0 are +0.
#pragma once

namespace morphcl {

struct SinCos {
  double sin, cos;
};

// Error(usage) for a NaN or infinite angle.
SinCos sin_cos_degrees(double degrees);

// Conversions: the nearest double, or the one beside it.
double radians(double degrees);
double degrees(double radians);

}  // namespace morphcl
