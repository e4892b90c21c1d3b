// Elementary functions built from + - * / sqrt and fma alone, so that every IEEE machine gives the same bits. (The C
// library gives different ones from version to version and from processor to processor.)
#pragma once

namespace morphcl {

// (sin x - x) / x^3 and (cos x - 1 + x^2/2) / x^4 as functions of z = x^2, for 0 <= z <= 2.5 (|x| <= pi/2), by their
// Taylor series: truncated below 2^-60 of the value, evaluated by Horner's rule with fma within 4u relative.
double sine_tail(double z);
double cosine_tail(double z);

// sin(x) / x for |x| <= pi/2, and 1 at x = 0; within 6u relative.
double sinc(double x);

// The angle in radians, in [0, pi/2], of the vector (x, y) with x, y >= 0 and not both 0; within 12u relative. The
// series is reached by halving the angle twice: tan(a/2) = t / (1 + sqrt(1 + t^2)).
double quadrant_angle(double y, double x);

}  // namespace morphcl
