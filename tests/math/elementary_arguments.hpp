// Families of arguments for functions of one double, from fixed seeds.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <random>

#include "tests/math/correct_rounding.hpp"

namespace morphcl::reference {

// By turns: [-1, 1], [-100, 100], [-750, 750], [-1e6, 1e6], small exponents, any exponent, and next to k pi / 2.
class ElementaryArguments {
 public:
  explicit ElementaryArguments(std::uint64_t seed) : engine_(seed) {}

  double next() {
    switch (family_++ % families) {
      case 0:
        return signed_unit();
      case 1:
        return 100 * signed_unit();
      case 2:
        return 750 * signed_unit();
      case 3:
        return 1e6 * signed_unit();
      case 4:
        return std::ldexp(signed_unit(), -static_cast<int>(engine_() % 64));
      case 5:
        return with_exponent(engine_() % 2047);
      default:
        return beside(near_quarter_turns(engine_() % 1'000'000'000));
    }
  }

 private:
  static constexpr unsigned families = 7;
  double signed_unit() { return std::ldexp(static_cast<double>(static_cast<std::int64_t>(engine_())), -63); }
  double with_exponent(std::uint64_t exponent) {
    return std::bit_cast<double>((engine_() & 0x800fffffffffffffu) | exponent << 52);
  }
  double beside(double x) { return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) + engine_() % 5 - 2); }

  std::mt19937_64 engine_;
  unsigned family_ = 0;
};

}  // namespace morphcl::reference
