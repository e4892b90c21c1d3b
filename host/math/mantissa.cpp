#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "host/math/widest_vectors.hpp"
#include "morphcl/error.hpp"
#include "morphcl/numerics.hpp"

namespace morphcl {

namespace {

constexpr std::uint32_t magnitude_bits = 0x7fffffff;
constexpr std::uint32_t infinity_bits = 0x7f800000;
constexpr std::uint32_t min_normal_bits = 0x00800000;

// u / (1 + u) <= error, as u - error <= error * u: the left side is exact where the two are of one size, and elsewhere
// its sign is plain; the fma rounds once, which keeps the sign.
bool keeps_error(int bits, double error) {
  const double u = std::ldexp(1.0, -(bits + 1));
  return std::fma(-error, u, u - error) <= 0;
}

// dropped: 1 to 23.
MORPHCL_WIDEST_VECTORS
void drop_bits(float* values, std::size_t count, int dropped, std::uint32_t kept) {
  const std::uint32_t below_half = (std::uint32_t{1} << (dropped - 1)) - 1;
  const std::uint32_t left = ~((std::uint32_t{1} << dropped) - 1);
  for (std::size_t i = 0; i < count; ++i) {
    const auto bits = std::bit_cast<std::uint32_t>(values[i]);
    const std::uint32_t magnitude = bits & magnitude_bits;
    const std::uint32_t odd = magnitude >> dropped & 1;
    const std::uint32_t nearest = (magnitude + below_half + odd) & left;
    const bool stays = magnitude < min_normal_bits || nearest >= infinity_bits || bits == kept;
    values[i] = std::bit_cast<float>(stays ? bits : nearest | (bits & ~magnitude_bits));
  }
}

}  // namespace

int mantissa_bits_for(double relative_error) {
  if (!(relative_error > 0 && relative_error <= max_relative_error))
    throw Error(ErrorKind::usage, "",
                fmt::format("a relative error of {}; more than 0 and at most {} is possible, such as 1e-6",
                            relative_error, max_relative_error));
  int bits = 0;
  while (bits < float_mantissa_bits && !keeps_error(bits, relative_error)) ++bits;
  return bits;
}

double step_for(double absolute_error) {
  if (!(absolute_error > 0 && absolute_error <= max_absolute_error))
    throw Error(ErrorKind::usage, "",
                fmt::format("an absolute error of {}; more than 0 and at most {} is possible, such as 1e-3",
                            absolute_error, max_absolute_error));
  int exponent = 0;
  std::frexp(absolute_error, &exponent);  // 2^(exponent - 1) <= absolute_error: half the step
  return std::ldexp(1.0, std::max(exponent, std::numeric_limits<double>::min_exponent));
}

void round_mantissas(std::span<float> values, int bits, float kept) {
  if (bits < float_mantissa_bits)
    drop_bits(values.data(), values.size(), float_mantissa_bits - bits, std::bit_cast<std::uint32_t>(kept));
}

}  // namespace morphcl
