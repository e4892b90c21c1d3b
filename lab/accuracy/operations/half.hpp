// binary16 as storage: one rounding from a double, exact back.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace morphcl::accuracy {

// Nearest, ties to even; beyond the largest half, the largest half. The value is finite.
inline std::uint16_t to_half(double value) {
  const double size = std::min(std::abs(value), 65504.0);
  const double quantum = std::ldexp(1.0, std::max(size > 0 ? std::ilogb(size) : -14, -14) - 10);
  const auto rounded = static_cast<float>(std::nearbyint(size / quantum) * quantum);
  const std::uint32_t bits = std::bit_cast<std::uint32_t>(rounded * 0x1p-112f) >> 13;
  return static_cast<std::uint16_t>(bits | (std::signbit(value) ? 0x8000u : 0u));
}

inline float from_half(std::uint16_t half) {
  const float size = std::bit_cast<float>((half & 0x7fffu) << 13) * 0x1p112f;
  return std::bit_cast<float>(std::bit_cast<std::uint32_t>(size) | ((half & 0x8000u) << 16));
}

}  // namespace morphcl::accuracy
