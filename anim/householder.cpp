#include "anim/householder.hpp"

#include <algorithm>
#include <cmath>

namespace morphcl {

namespace {

double square_length(const double* v, std::size_t count) {
  double sum = 0;
  for (std::size_t i = 0; i < count; ++i) sum += v[i] * v[i];
  return sum;
}

// x -= v (v . x), v of length sqrt(2).
void reflect(const std::vector<double>& v, double* x) {
  double along = 0;
  for (std::size_t i = 0; i < v.size(); ++i) along += v[i] * x[i];
  for (std::size_t i = 0; i < v.size(); ++i) x[i] -= along * v[i];
}

// The reflection that turns x into a multiple of the first axis; empty when it is one.
std::vector<double> reflection_of(const double* x, std::size_t count) {
  const double rest = square_length(x + 1, count - 1);
  if (rest == 0) return {};
  const double length = std::sqrt(x[0] * x[0] + rest);
  std::vector<double> v(x, x + count);
  v[0] += std::copysign(length, x[0]);
  const double scale = std::sqrt(2 / (v[0] * v[0] + rest));
  for (double& component : v) component *= scale;
  return v;
}

}  // namespace

HouseholderQr::HouseholderQr(DenseMatrix& a, Pivoting pivoting) {
  const std::size_t steps = std::min(a.rows, a.columns);
  for (std::size_t i = 0; i < steps; ++i) {
    const std::size_t left = a.rows - i;
    if (pivoting == Pivoting::columns) {
      std::size_t longest = i;
      double max_square = -1;
      for (std::size_t c = i; c < a.columns; ++c) {
        const double square = square_length(a.column(c) + i, left);
        if (square > max_square) {
          max_square = square;
          longest = c;
        }
      }
      std::swap_ranges(a.column(i), a.column(i) + a.rows, a.column(longest));
    }
    std::vector<double> v = reflection_of(a.column(i) + i, left);
    for (std::size_t c = i; c < a.columns && !v.empty(); ++c) reflect(v, a.column(c) + i);
    std::fill(a.column(i) + i + 1, a.column(i) + a.rows, 0.0);
    reflections_.push_back(std::move(v));
  }
}

void HouseholderQr::apply_q(double* x) const {
  for (std::size_t i = reflections_.size(); i-- > 0;)
    if (!reflections_[i].empty()) reflect(reflections_[i], x + i);
}

}  // namespace morphcl
