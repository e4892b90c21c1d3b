// Sine and cosine with more than 180 bits in integer arithmetic: the second phase of the correctly rounded functions,
// entered where the first cannot tell to which double a value is rounded (one argument in thousands).
//
// Method: Taylor series by Horner's rule in r^2, 28 terms, truncated below 2^-256.
#pragma once

#include "host/math/fixed_256.hpp"

namespace morphcl {

// For r in [0, pi/4]; the sine within 2^-248 of itself, however small r is.
Float256 accurate_sine(const Float256& r);
Fixed256 accurate_cosine(const Float256& r);  // within 2^-248

}  // namespace morphcl
