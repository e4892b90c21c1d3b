// The exponential function, correctly rounded: the double nearest to the exact value, so the same bits on every
// machine.
//
// Method: Ziv's two phases as in trigonometry.hpp. x = k ln 2 + r with |r| <= 0.35, r in double-double arithmetic;
// e^(r/8) - 1 by its Taylor series, squared three times as s (s + 2), within 2^-67 relative; where that leaves two
// doubles possible, the series of e^r in 256-bit integers. The hardest argument is known to need 53 + 60 bits (Lefevre
// and Muller 2001), but for those below 2^-30, whose hardness is that of 1 + x + x^2/2; at most some 53 + 110.
// Compared with MPFR at 20 million arguments each of both functions: no miss.
//
// Special values: e^-inf = 0, e^inf = inf, NaN for NaN; exponential_minus_1(-0) = -0, and -1 for -inf. Results too
// large are infinite, those too small subnormal or 0.
#pragma once

namespace morphcl {

double exponential(double x);          // e^x
double exponential_minus_1(double x);  // e^x - 1, also where x is small

}  // namespace morphcl
