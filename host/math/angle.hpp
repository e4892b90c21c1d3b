// Sine and cosine of an angle in degrees, exact at every multiple of 90 degrees and with one reduction modulo 360 that is
// itself exact, so that 1e15 + 30 degrees is as good as 30. Error of the general case: the host library's sin and cos of
// an argument in [-45, 45] degrees plus one rounding of the conversion to radians: at most 2 ulp.
#pragma once

namespace morphcl {

struct SinCos {
  double sin, cos;
};

SinCos sin_cos_degrees(double degrees);
double radians(double degrees);

}  // namespace morphcl
