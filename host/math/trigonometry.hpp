// Sine, cosine, tangent and arc tangent in radians, correctly rounded: the double nearest to the exact value for the
// given doubles, so the same bits on every machine. (The C library's differ from version to version and from processor
// to processor.)
//
// Method: Ziv (1991). A first phase of about 70 bits (sine_kernel.hpp) decides nearly always; where its error bound
// leaves two doubles possible, a second one of more than 180 bits in integers (accurate_sine.hpp) decides. Arguments of
// any size are reduced exactly (quarter_turns.hpp). The hardest arguments published need some 53 + 70 bits; that none
// needs 180 is not proved for sine, cosine and tangent of large numbers and for the arc tangent, but the chance that
// one of them does is below 2^-50.
//
// Compared with MPFR (tests/math/count_misroundings.cpp): 20 million arguments each of sine, cosine, tangent and of the
// arc tangents of x / 1, 1 / x and x / -3, one million each of sine and cosine of degrees; no miss.
//
// Special values are those that IEEE 754 recommends: NaN for infinite angles, -0 for -0, and for the arc tangent the
// sign of y and the half-plane of x, zeros and infinities included.
#pragma once

namespace morphcl {

double sine(double x);
double cosine(double x);
double tangent(double x);

// The angle of the vector (x, y) in [-pi, pi].
double arc_tangent(double y, double x);

}  // namespace morphcl
