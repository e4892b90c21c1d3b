// Positive tests for finite numbers: written so that NaN fails them.
#pragma once

#include <cmath>
#include <glm/glm.hpp>

namespace morphcl {

inline bool is_finite(double value) { return std::isfinite(value); }

template <int N>
bool is_finite(const glm::vec<N, double>& vector) {
  for (int i = 0; i < N; ++i)
    if (!std::isfinite(vector[i])) return false;
  return true;
}

template <int C, int R>
bool is_finite(const glm::mat<C, R, double>& matrix) {
  for (int i = 0; i < C; ++i)
    if (!is_finite(matrix[i])) return false;
  return true;
}

}  // namespace morphcl
