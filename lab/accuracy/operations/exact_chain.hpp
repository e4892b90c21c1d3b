// The chain of chain_integrators.hpp exactly: by the exponential of its matrix, in as many digits as Number has.
#pragma once

#include <vector>

#include "lab/accuracy/operations/chain_integrators.hpp"

namespace morphcl::accuracy {

// What drives mass i at a frame: multiples of 1/64.
inline double chain_target(double phase, int frame, std::size_t i) {
  const auto n = static_cast<long>(phase) + frame;
  return static_cast<double>((7 * n * n + 3 * n) % 11) / 8 * (1 + static_cast<double>(i) / 8);
}

// The exponential of the system (x, v, g, g')' = A (x, v, g, g') over a frame of 1/24 s, by scaling and squaring: with
// a norm below 2^38 the squarings lose 38 bits.
template <class Number>
class ChainExponential {
 public:
  ChainExponential() {
    constexpr int squarings = 40;
    std::vector<Number> scaled(size * size);
    const Number h = Number(1) / 24 / ldexp(Number(1), squarings);
    const auto set = [&](std::size_t row, std::size_t column, double value) {
      scaled[row * size + column] = value * h;
    };
    for (std::size_t i = 0; i < n; ++i) {
      set(i, n + i, 1);
      set(n + i, 2 * n + i, 1);
      set(2 * n + i, 3 * n + i, 1);
      ChainVector unit{};
      unit[i] = 1;
      const ChainVector k = stiffness_times(unit);
      for (std::size_t row = 0; row < n; ++row) {
        set(n + row, i, -k[row]);
        scaled[(n + row) * size + n + i] = -(Number(row == i ? 2 : 0) + Number(k[row]) / 100'000'000) * h;
      }
    }
    // Below 2^-2 the terms fall by more than 2^-2 / k each: 60 of them are more than 350 bits.
    std::vector<Number> term = identity();
    values_ = term;
    for (int k = 1; k <= 60; ++k) {
      term = product(term, scaled);
      for (std::size_t e = 0; e < size * size; ++e) values_[e] += term[e] /= k;
    }
    for (int s = 0; s < squarings; ++s) values_ = product(values_, values_);
  }

  std::vector<Number> times(const std::vector<Number>& vector) const {
    std::vector<Number> result(size, Number(0));
    for (std::size_t row = 0; row < size; ++row)
      for (std::size_t column = 0; column < size; ++column)
        result[row] += values_[row * size + column] * vector[column];
    return result;
  }

  static constexpr std::size_t n = chain_masses, size = 4 * n;

 private:
  static std::vector<Number> identity() {
    std::vector<Number> m(size * size, Number(0));
    for (std::size_t i = 0; i < size; ++i) m[i * size + i] = 1;
    return m;
  }

  static std::vector<Number> product(const std::vector<Number>& a, const std::vector<Number>& b) {
    std::vector<Number> c(size * size, Number(0));
    for (std::size_t row = 0; row < size; ++row)
      for (std::size_t k = 0; k < size; ++k) {
        const Number& factor = a[row * size + k];
        if (factor == 0) continue;
        for (std::size_t column = 0; column < size; ++column) c[row * size + column] += factor * b[k * size + column];
      }
    return c;
  }

  std::vector<Number> values_;
};

// Positions after `frames` frames from rest.
template <class Number>
std::array<Number, chain_masses> exact_chain(double phase, int frames) {
  static const ChainExponential<Number> frame;
  constexpr std::size_t n = chain_masses;
  std::vector<Number> state(4 * n, Number(0));
  for (int k = 0; k < frames; ++k) {
    for (std::size_t i = 0; i < n; ++i) {
      state[2 * n + i] = chain_target(phase, k, i);
      state[3 * n + i] = (Number(chain_target(phase, k + 1, i)) - chain_target(phase, k, i)) * 24;
    }
    state = frame.times(state);
  }
  std::array<Number, chain_masses> positions;
  for (std::size_t i = 0; i < n; ++i) positions[i] = state[i];
  return positions;
}

}  // namespace morphcl::accuracy
