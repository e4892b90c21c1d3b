// zlib streams (RFC 1950) of whole buffers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

namespace morphcl {

enum class ZlibEffort {
  fast,   // the least time: ISA-L's igzip where this build has it, else libdeflate at a low level
  small,  // the least bytes that do not cost many times more: libdeflate
};

// Keeps its memory from call to call; for one thread at a time. The bytes differ between versions of the compression
// libraries, what they decode to does not.
class ZlibEncoder {
 public:
  virtual ~ZlibEncoder() = default;
  // Writes the stream of `in` to the beginning of `out` and returns its length; 0 when there is no room for it and a
  // few bytes more. The same input gives the same stream, whatever came before. `adler` is the Adler-32 of `in`, by who
  // knows it with less work than a look at every byte.
  virtual std::size_t encode(std::span<const std::uint8_t> in, std::uint32_t adler, std::span<std::uint8_t> out) = 0;
};

std::unique_ptr<ZlibEncoder> make_zlib_encoder(ZlibEffort effort);

// Pieces of one deflate stream (RFC 1951), each compressed by itself: in any order, by several threads. Behind the last
// piece belongs an empty block that says that it is the last, which is not made here.
class DeflatePieces {
 public:
  virtual ~DeflatePieces() = default;
  // Replaces `out` by whole blocks for `in`, none of which is the stream's last; they end on a byte. The same input
  // gives the same blocks, whatever came before.
  virtual void encode(std::span<const std::uint8_t> in, std::vector<std::uint8_t>& out) = 0;
};

// In the least time: by igzip where this build has it, else by zlib, as libdeflate makes whole streams alone.
std::unique_ptr<DeflatePieces> make_deflate_pieces();
std::unique_ptr<DeflatePieces> make_zlib_deflate_pieces();

// The library behind `fast`: "igzip" or "libdeflate".
std::string_view fast_zlib_library();

}  // namespace morphcl
