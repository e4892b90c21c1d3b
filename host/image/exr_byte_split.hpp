// What OpenEXR's ZIP compression does to a chunk's bytes before they are deflated: all bytes at even positions, then
// all at odd ones, and each byte but the first replaced by its difference to the byte before it, plus 128.
//
// Pixels change little from one to the next, so this turns most of them into runs of 128 (OpenEXR file layout, "ZIP").
#pragma once

#include <cstddef>
#include <cstdint>

namespace morphcl {

// Takes a chunk's bytes piece by piece, in the file's order, and writes the prepared ones.
class ExrByteSplit {
 public:
  // out: as many bytes as add() will be given in total, an even number.
  ExrByteSplit(std::uint8_t* out, std::size_t bytes) : even_(out), odd_(out + bytes / 2), first_odd_(odd_) {}

  // The 2 * pairs bytes at `bytes`; pairs >= 1.
  void add(const void* bytes, std::size_t pairs);
  // The same of pairs that are `first` and `second` by turns.
  void add_by_turns(std::uint16_t first, std::uint16_t second, std::size_t pairs);
  void finish();  // once, after the last add()

 private:
  std::uint8_t *even_, *odd_, *first_odd_;
  // The pair before. The very first byte has no difference: 128 before it leaves it as it is.
  std::uint16_t previous_ = 128;
};

}  // namespace morphcl
