// The root of x^5 = value, by correctly rounded operations alone: no pow of a C library, as those differ.
#pragma once

namespace morphcl {

// value: 0 to 1. Within an ulp.
inline double fifth_root(double value) {
  double root = 1;
  for (double next = 0;; root = next) {
    const double square = root * root;
    const double fourth = square * square;
    next = root - (fourth * root - value) / (5 * fourth);
    if (next >= root) return root;  // Newton's iteration falls until it is exact but for rounding
  }
}

}  // namespace morphcl
