// Chunks, of which PNG files are made (ISO/IEC 15948): length, type, data, CRC; numbers have the high byte first.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace morphcl {

inline constexpr std::array<std::uint8_t, 8> png_signature{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
inline constexpr std::size_t png_longest_chunk = 0x7fffffff;

// Keys of the texts that say what a frame's file is of.
inline constexpr std::string_view frame_text = "morphclFrame", fingerprint_text = "morphclFingerprint",
                                  deviation_text = "morphclDeviation", pixel_hash_text = "pixelHash";

std::array<std::uint8_t, 4> big_endian_bytes(std::uint32_t value);
// The number in the first four bytes.
std::uint32_t big_endian(const char* bytes);

// `type`: four letters. The data stands in two pieces, the second of which may be empty.
void append_chunk(std::vector<char>& bytes, std::string_view type, std::span<const std::uint8_t> data,
                  std::span<const std::uint8_t> more = {});
void append_text_chunk(std::vector<char>& bytes, std::string_view key, std::string_view text);

}  // namespace morphcl
