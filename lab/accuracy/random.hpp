// Pseudo-random numbers that are the same on every machine, which the distributions of the standard library are not.
// Each number is drawn in a statement of its own: compilers differ in which argument of a call they evaluate first.
//
// Source of the method: SplitMix64 (Steele, Lea and Flood, 2014).
#pragma once

#include <cmath>
#include <cstdint>

namespace morphcl::accuracy {

class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  std::uint64_t bits() {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return z ^ (z >> 31);
  }
  // In [low, high).
  double uniform(double low, double high) { return low + (high - low) * (static_cast<double>(bits() >> 11) * 0x1p-53); }
  // In [low, high]; both well within 32 bits.
  int integer(int low, int high) { return low + static_cast<int>(bits() % static_cast<std::uint64_t>(high - low + 1)); }
  // Magnitudes between 2^low and 2^(high + 1), each binade as likely; positive.
  double binades(int low, int high) {
    const int exponent = integer(low, high);
    return std::ldexp(uniform(1, 2), exponent);
  }
  // The same with either sign.
  double signed_binades(int low, int high) {
    const double magnitude = binades(low, high);
    return (bits() & 1) != 0 ? magnitude : -magnitude;
  }

 private:
  std::uint64_t state_;
};

}  // namespace morphcl::accuracy
