// An angle in radians as quarter turns and a rest, exactly: the argument reduction of the trigonometric functions.
//
// Method: Payne and Hanek (1983). x = m * 2^e with an integer m; of x / (2 pi) only the bits of 1 / (2 pi) matter that
// are neither worth whole turns nor below the result's precision, so six 64-bit words of a table times m give the
// fraction of a turn within 2^-260. No double is closer to a multiple of pi/2 than 2^-62 quarter turns (Muller et al.,
// Handbook of Floating-Point Arithmetic, 11.2), so the rest has 190 correct bits at least.
#pragma once

#include "host/math/double_double.hpp"
#include "host/math/fixed_256.hpp"

namespace morphcl {

// x = (quarters + rest) * pi/2, or (quarters - rest) * pi/2 where `below`; rest in [0, 1/2], within 2^-256.
struct QuarterTurns {
  unsigned quarters = 0;  // modulo 4
  bool below = false;
  Fixed256 rest;
};

// x >= 2^-54 and finite.
QuarterTurns quarter_turns(double x);

// The rest within 2^-105 relative. 0 < rest < 1.
DoubleDouble to_double_double(const Fixed256& rest);

}  // namespace morphcl
