// Pseudo-random numbers from a fixed seed. Bounds and counts in tests are tuned to these sequences: they must not
// change. The generator SplitMix64, with which some frames and batches are filled, is in lab/accuracy/random.hpp.
#pragma once

#include <cmath>
#include <cstdint>
#include <glm/vec3.hpp>
#include <random>

namespace morphcl::test_support {

// Uniform numbers of the 64-bit Mersenne Twister, the same on every machine.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  // In [low, high).
  double in(double low, double high) {
    return low + (high - low) * std::ldexp(static_cast<double>(engine_() >> 11), -53);
  }
  float float_in(double low, double high) { return static_cast<float>(in(low, high)); }
  // In [low, high].
  long long integer_in(long long low, long long high) {
    return low + static_cast<long long>(engine_() % static_cast<std::uint64_t>(high - low + 1));
  }
  // Each coordinate in [-size, size).
  glm::dvec3 vector(double size) { return {in(-size, size), in(-size, size), in(-size, size)}; }

 private:
  std::mt19937_64 engine_;
};

// Uniform numbers of the 32-bit Mersenne Twister by the distribution of the standard library at hand.
class Random32 {
 public:
  explicit Random32(unsigned seed) : engine_(seed) {}
  // In [-reach, reach).
  double number(double reach = 1) { return std::uniform_real_distribution<double>(-reach, reach)(engine_); }
  glm::dvec3 vector(double reach = 1) { return {number(reach), number(reach), number(reach)}; }
  bool one_in(unsigned n) { return below(n) == 0; }
  // In [0, n).
  unsigned below(unsigned n) { return static_cast<unsigned>(engine_() % n); }

 private:
  std::mt19937 engine_;
};

}  // namespace morphcl::test_support
