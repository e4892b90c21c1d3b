// Adler-32 (RFC 1950) of bytes of which some are known to repeat themselves.
#pragma once

#include <cstddef>
#include <cstdint>

namespace morphcl {

class RunningAdler32 {
 public:
  void add(const std::uint8_t* bytes, std::size_t count);
  // The same of `count` bytes that are bytes[0] and bytes[1] by turns, of which no others are read.
  void add_by_turns(const std::uint8_t* bytes, std::size_t count);
  std::uint32_t value() const { return value_; }

 private:
  std::uint32_t value_ = 1;
};

}  // namespace morphcl
