// pi and its relatives to more than 256 bits.
#pragma once

#include <array>
#include <cstdint>

#include "host/math/double_double.hpp"
#include "host/math/fixed_256.hpp"

namespace morphcl {

constexpr DoubleDouble pi_double_double{0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53};
constexpr DoubleDouble half_pi_double_double{0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54};
constexpr DoubleDouble radians_per_degree_double_double{0x1.1df46a2529d39p-6, 0x1.5c1d8becdd291p-62};

// Least significant limb first, as Fixed256 has them.
constexpr Fixed256 pi_fixed{{0x082efa98ec4e6c89, 0xa4093822299f31d0, 0x13198a2e03707344, 0x243f6a8885a308d3, 3}};
constexpr Fixed256 half_pi_fixed{{0x04177d4c76273644, 0x52049c1114cf98e8, 0x898cc51701b839a2, 0x921fb54442d18469, 1}};

// pi / 180 = 0.55850... * 2^-5: a mantissa in [1/2, 1) and its exponent.
constexpr Float256 radians_per_degree_float{
    {{0xe502a9b4c94c8512, 0x00b7aef501b5e6b8, 0x0ec5f66e9485c4d9, 0x8efa351294e9c8ae, 0}}, -5};

}  // namespace morphcl
