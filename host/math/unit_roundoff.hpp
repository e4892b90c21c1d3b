// The unit roundoff u: rounding to nearest changes a number by at most u times its magnitude.
#pragma once

#include <limits>

namespace morphcl {

// 2^-24 of float, 2^-53 of double.
template <class Real>
inline constexpr Real unit_roundoff = std::numeric_limits<Real>::epsilon() / 2;

}  // namespace morphcl
