// Attributes along the picture of an edge: linear in space, not in the picture.
//
// Weights of both ends are formed as products, t and 1 - t apart, so that no end is lost however much the distances
// differ: at most 3.1 ulp for attributes of the same sign, else 5u max |a|; exact at t = 0 and t = 1. The form
// p + t (q - p) of the reciprocals loses 1e6 ulp at a ratio of distances of 1e6.
#pragma once

#include <cmath>

namespace morphcl {

// The attribute where the picture of the edge is divided 1 - t to t; a1, a2 at the ends, w1, w2 > 0 their distances
// (clip-space w), t in [0, 1]. T is float or double.
template <typename T>
T perspective_lerp(T a1, T w1, T a2, T w2, T t) {
  if (t == 0) return a1;
  if (t == 1) return a2;
  const T first = w2 * (1 - t), second = w1 * t;
  return std::fma(a1, first, a2 * second) / (first + second);
}

}  // namespace morphcl
