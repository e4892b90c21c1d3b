#include "host/murmur3.hpp"

#include <bit>
#include <cstddef>

namespace morphcl {

namespace {

std::uint32_t byte_at(std::string_view text, std::size_t i) { return static_cast<unsigned char>(text[i]); }

std::uint32_t scrambled(std::uint32_t word) { return std::rotl(word * 0xcc9e2d51u, 15) * 0x1b873593u; }

}  // namespace

std::uint32_t murmur3_32(std::string_view text, std::uint32_t seed) {
  std::uint32_t hash = seed;
  const std::size_t words = text.size() / 4, rest = text.size() % 4;
  for (std::size_t i = 0; i < 4 * words; i += 4) {
    const std::uint32_t word = byte_at(text, i) | byte_at(text, i + 1) << 8 | byte_at(text, i + 2) << 16 |
                               byte_at(text, i + 3) << 24;  // little-endian
    hash = std::rotl(hash ^ scrambled(word), 13) * 5 + 0xe6546b64u;
  }
  std::uint32_t last = 0;
  for (std::size_t i = 0; i < rest; ++i) last |= byte_at(text, 4 * words + i) << 8 * i;
  hash ^= scrambled(last);  // 0 where nothing is left
  hash ^= static_cast<std::uint32_t>(text.size());
  hash = (hash ^ hash >> 16) * 0x85ebca6bu;
  hash = (hash ^ hash >> 13) * 0xc2b2ae35u;
  return hash ^ hash >> 16;
}

}  // namespace morphcl
