#include "host/image/exr_byte_split.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

#include "host/math/widest_vectors.hpp"

namespace morphcl {

static_assert(std::endian::native == std::endian::little, "the low byte of a pair is the one at the even position");

namespace {

std::uint16_t pair_at(const unsigned char* bytes, std::size_t i) {
  std::uint16_t pair;
  std::memcpy(&pair, bytes + 2 * i, sizeof pair);
  return pair;
}

std::uint8_t low_difference(std::uint16_t pair, std::uint16_t before) {
  return static_cast<std::uint8_t>(pair - before + 128);
}

std::uint8_t high_difference(std::uint16_t pair, std::uint16_t before) {
  return static_cast<std::uint8_t>((pair >> 8) - (before >> 8) + 128);
}

// Fills `count` bytes with those two before them, which are there.
void repeat_last_two(std::uint8_t* out, std::size_t count) {
  if (out[-1] == out[-2]) {
    std::memset(out, out[-1], count);
    return;
  }
  const std::uint8_t* const from = out - 2;
  for (std::size_t there = 2; count > 0;) {
    const std::size_t taken = std::min(there, count);
    std::memcpy(out, from, taken);
    out += taken;
    count -= taken;
    there += taken;
  }
}

// All pairs but the first. Compilers make vectors of this: pairs are loaded whole, at i and i - 1, and narrowed.
MORPHCL_WIDEST_VECTORS
void split_rest(const unsigned char* in, std::size_t pairs, std::uint8_t* __restrict even,
                std::uint8_t* __restrict odd) {
  for (std::size_t i = 1; i < pairs; ++i) {
    even[i] = low_difference(pair_at(in, i), pair_at(in, i - 1));
    odd[i] = high_difference(pair_at(in, i), pair_at(in, i - 1));
  }
}

}  // namespace

void ExrByteSplit::add(const void* bytes, std::size_t pairs) {
  const auto* const in = static_cast<const unsigned char*>(bytes);
  even_[0] = low_difference(pair_at(in, 0), previous_);
  odd_[0] = high_difference(pair_at(in, 0), previous_);
  split_rest(in, pairs, even_, odd_);
  previous_ = pair_at(in, pairs - 1);
  even_ += pairs;
  odd_ += pairs;
}

void ExrByteSplit::add_by_turns(std::uint16_t first, std::uint16_t second, std::size_t pairs) {
  constexpr std::size_t different = 3;  // from then on differences are those of two pairs before
  const std::array<std::uint16_t, different> begin{first, second, first};
  add(begin.data(), std::min(pairs, different));
  if (pairs <= different) return;
  const std::size_t left = pairs - different;
  repeat_last_two(even_, left);
  repeat_last_two(odd_, left);
  previous_ = pairs % 2 == 0 ? second : first;
  even_ += left;
  odd_ += left;
}

void ExrByteSplit::finish() {
  // The byte before the first odd one is the last even one, which was not known when add() had 0 in its place.
  *first_odd_ = static_cast<std::uint8_t>(*first_odd_ - (previous_ & 0xff));
}

}  // namespace morphcl
