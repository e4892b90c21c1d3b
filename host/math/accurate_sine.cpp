#include "host/math/accurate_sine.hpp"

namespace morphcl {

namespace {

// 1 - z / (n (n + 1)) + z^2 / (n (n + 1) (n + 2) (n + 3)) - ...
Fixed256 alternating_series(const Fixed256& z, unsigned n) {
  constexpr unsigned terms = 28;
  Fixed256 sum = fixed_one;
  for (unsigned k = terms; k-- > 0;) {
    const std::uint64_t first = n + 2 * k;
    sum = fixed_one - z * sum / (first * (first + 1));
  }
  return sum;
}

}  // namespace

Float256 accurate_sine(const Float256& r) {
  const Fixed256 z = to_fixed_256(r * r);
  const Fixed256 sine_over_r = alternating_series(z, 2);
  // Where r^2 is lost below 2^-256 the sine is still a little less than r.
  constexpr Fixed256 below_one{{~std::uint64_t{0}, ~std::uint64_t{0}, ~std::uint64_t{0}, ~std::uint64_t{0}, 0}};
  return r * to_float_256(sine_over_r < fixed_one ? sine_over_r : below_one);
}

Fixed256 accurate_cosine(const Float256& r) { return alternating_series(to_fixed_256(r * r), 1); }

}  // namespace morphcl
