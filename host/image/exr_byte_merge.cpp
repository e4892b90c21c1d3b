#include "host/image/exr_byte_merge.hpp"

#include <bit>
#include <cstring>

namespace morphcl {

static_assert(std::endian::native == std::endian::little, "the first of eight bytes is the lowest of a word");

namespace {

// Eight sums of bytes, each modulo 256.
std::uint64_t add_bytes(std::uint64_t a, std::uint64_t b) {
  constexpr std::uint64_t low_bits = 0x7f7f7f7f7f7f7f7f;
  return ((a & low_bits) + (b & low_bits)) ^ ((a ^ b) & ~low_bits);
}

}  // namespace

// Eight at a time: within a word by three shifted sums, and the last byte goes on to the next word.
void add_up_differences(std::uint8_t* bytes, std::size_t count) {
  constexpr std::uint64_t every_byte = 0x0101010101010101, offset = 0x80 * every_byte;
  std::uint64_t before = 0x80 * every_byte;  // the first byte is no difference: 128 before it leaves it as it is
  std::size_t i = 0;
  for (; i + 8 <= count; i += 8) {
    std::uint64_t word;
    std::memcpy(&word, bytes + i, sizeof word);
    word ^= offset;  // less 128, each
    word = add_bytes(word, word << 8);
    word = add_bytes(word, word << 16);
    word = add_bytes(word, word << 32);
    word = add_bytes(word, before);
    std::memcpy(bytes + i, &word, sizeof word);
    before = (word >> 56) * every_byte;
  }
  auto sum = static_cast<std::uint8_t>(before);
  for (; i < count; ++i) {
    sum = static_cast<std::uint8_t>(sum + bytes[i] - 128);
    bytes[i] = sum;
  }
}

void merge_bytes(void* out, const std::uint8_t* even, const std::uint8_t* odd, std::size_t pairs) {
  auto* const bytes = static_cast<unsigned char*>(out);
  for (std::size_t i = 0; i < pairs; ++i) {
    const auto pair = static_cast<std::uint16_t>(even[i] | odd[i] << 8);
    std::memcpy(bytes + 2 * i, &pair, sizeof pair);
  }
}

}  // namespace morphcl
