#include "host/math/quarter_turns.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace morphcl {

namespace {

__extension__ using Wide = unsigned __int128;

// 1 / (2 pi), the bits behind the point.
constexpr std::array<std::uint64_t, 21> one_over_two_pi = {
    0x28be60db9391054a, 0x7f09d5f47d4d3770, 0x36d8a5664f10e410, 0x7f9458eaf7aef158, 0x6dc91b8e909374b8,
    0x01924bba82746487, 0x3f877ac72c4a69cf, 0xba208d7d4baed121, 0x3a671c09ad17df90, 0x4e64758e60d4ce7d,
    0x272117e2ef7e4a0e, 0xc7fe25fff7816603, 0xfbcbc462d6829b47, 0xdb4d9fb3c9f2c26d, 0xd3d18fd9a797fa8b,
    0x5d49eeb1faf97c5e, 0xcf41ce7de294a4ba, 0x9afed7ec47e35742, 0x1580cc11bf1edaea, 0xfc33ef0826bd0d87,
    0x6a78e45857b986c2};

constexpr std::size_t words = 6;                   // of the table that are multiplied
using Product = std::array<std::uint64_t, words>;  // a fraction of a turn, most significant first

}  // namespace

QuarterTurns quarter_turns(double x) {
  int exponent = 0;
  const auto mantissa = static_cast<std::uint64_t>(std::ldexp(std::frexp(x, &exponent), 53));
  exponent -= 53;
  // Words before `first` times x are whole turns. Then x = mantissa * 2^shift * 2^(64 first).
  const int first = exponent > 0 ? exponent / 64 : 0;
  const int shift = exponent - 64 * first;

  Product fraction{};
  std::uint64_t carry = 0;
  for (std::size_t i = words; i-- > 0;) {
    const Wide part = Wide{mantissa} * one_over_two_pi[static_cast<std::size_t>(first) + i] + carry;
    fraction[i] = static_cast<std::uint64_t>(part);
    carry = static_cast<std::uint64_t>(part >> 64);
  }
  // The carry is whole turns, unless the product is shifted to the right.
  for (std::size_t i = 0; shift > 0 && i < words; ++i)
    fraction[i] = fraction[i] << shift | (i + 1 < words ? fraction[i + 1] >> (64 - shift) : 0);
  for (std::size_t i = words; shift < 0 && i-- > 0;)
    fraction[i] = fraction[i] >> -shift | (i > 0 ? fraction[i - 1] : carry) << (64 + shift);

  QuarterTurns result;
  result.quarters = static_cast<unsigned>(fraction[0] >> 62);
  for (std::size_t i = 0; i < 4; ++i) result.rest.limb[3 - i] = fraction[i] << 2 | fraction[i + 1] >> 62;
  result.below = result.rest.limb[3] >> 63 != 0;
  if (result.below) {
    result.rest = fixed_one - result.rest;
    result.quarters = (result.quarters + 1) % 4;
  }
  return result;
}

DoubleDouble to_double_double(const Fixed256& rest) {
  std::size_t top = 3;
  while (top > 1 && rest.limb[top] == 0) --top;
  const int zeros = std::countl_zero(rest.limb[top]);
  const Wide first = Wide{rest.limb[top]} << 64 | rest.limb[top - 1];
  const Wide bits = first << zeros | (zeros == 0 || top < 2 ? 0 : rest.limb[top - 2] >> (64 - zeros));
  // An exact head of 53 bits, and the 64 behind it, rounded.
  const auto head = static_cast<std::uint64_t>(bits >> 75);
  const auto tail = static_cast<std::uint64_t>(bits >> 11);
  const int exponent = 64 * (static_cast<int>(top) - 3) - zeros;
  const auto power_of_two = [](int power) {
    return std::bit_cast<double>(static_cast<std::uint64_t>(1023 + power) << 52);
  };
  return fast_two_sum(static_cast<double>(head) * power_of_two(exponent - 53),
                      static_cast<double>(tail) * power_of_two(exponent - 117));
}

}  // namespace morphcl
