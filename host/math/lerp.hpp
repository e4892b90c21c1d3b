// Linear interpolation that keeps its ends.
//
// Exact at t = 0, at t = 1 and where a equals b; never overflows for t in [0, 1]. Error at most 1 ulp when a and b have
// the same sign, else half an ulp of the result plus u |a|. The forms a + t (b - a) and (1 - t) a + t b keep none of
// the three.
#pragma once

#include <cmath>

namespace morphcl {

// (1 - t) a + t b. T is float or double.
template <typename T>
T lerp(T a, T b, T t) {
  return std::fma(t, b, std::fma(-t, a, a));
}

}  // namespace morphcl
