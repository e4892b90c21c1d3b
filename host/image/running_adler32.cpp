#include "host/image/running_adler32.hpp"

#include <libdeflate.h>

namespace morphcl {

namespace {
constexpr std::uint64_t modulus = 65521;
constexpr int sum_bits = 16;
}  // namespace

void RunningAdler32::add(const std::uint8_t* bytes, std::size_t count) {
  if (count > 0) value_ = libdeflate_adler32(value_, bytes, count);
}

// The low sum is of the bytes. The high one adds it up after each byte, so that of p pairs the last byte counts once,
// the one before it twice: the first bytes of pairs count 2 + 4 + ... + 2 p times, the second ones 1 + 3 + ... + 2 p
// - 1.
void RunningAdler32::add_by_turns(const std::uint8_t* bytes, std::size_t count) {
  const std::uint64_t pairs = count / 2 % modulus, low = value_ & ((1u << sum_bits) - 1), high = value_ >> sum_bits;
  if (count >= 2) {
    const std::uint64_t first = bytes[0], second = bytes[1];
    const std::uint64_t new_low = (low + pairs * (first + second)) % modulus;
    const std::uint64_t new_high =
        (high + 2 * pairs * low + pairs * (pairs + 1) % modulus * first + pairs * pairs % modulus * second) % modulus;
    value_ = static_cast<std::uint32_t>(new_high << sum_bits | new_low);
  }
  if (count % 2 != 0) add(bytes, 1);
}

}  // namespace morphcl
