#include "host/cryptomatte_id.hpp"

#include <algorithm>
#include <bit>

#include "host/murmur3.hpp"

namespace morphcl {

std::uint32_t cryptomatte_bits(std::string_view name) {
  constexpr std::uint32_t mantissa_bits = 23, exponent_mask = 0xffu << mantissa_bits;
  const std::uint32_t hash = murmur3_32(name);
  const std::uint32_t exponent = std::clamp<std::uint32_t>((hash & exponent_mask) >> mantissa_bits, 1, 254);
  return (hash & ~exponent_mask) | exponent << mantissa_bits;
}

float cryptomatte_id(std::string_view name) { return std::bit_cast<float>(cryptomatte_bits(name)); }

}  // namespace morphcl
