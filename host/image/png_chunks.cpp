#include "host/image/png_chunks.hpp"

#include <libdeflate.h>

#include <string>

namespace morphcl {

namespace {

std::span<const std::uint8_t> bytes_of_text(std::string_view text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

}  // namespace

std::array<std::uint8_t, 4> big_endian_bytes(std::uint32_t value) {
  return {static_cast<std::uint8_t>(value >> 24), static_cast<std::uint8_t>(value >> 16),
          static_cast<std::uint8_t>(value >> 8), static_cast<std::uint8_t>(value)};
}

std::uint32_t big_endian(const char* bytes) {
  std::uint32_t value = 0;
  for (int i = 0; i < 4; ++i) value = value << 8 | static_cast<std::uint8_t>(bytes[i]);
  return value;
}

void append_chunk(std::vector<char>& bytes, std::string_view type, std::span<const std::uint8_t> data,
                  std::span<const std::uint8_t> more) {
  const auto length = big_endian_bytes(static_cast<std::uint32_t>(data.size() + more.size()));
  bytes.insert(bytes.end(), length.begin(), length.end());
  std::uint32_t crc = 0;
  for (const std::span<const std::uint8_t> piece : {bytes_of_text(type), data, more}) {
    if (piece.empty()) continue;  // for libdeflate no bytes at no address are a new beginning
    bytes.insert(bytes.end(), piece.begin(), piece.end());
    crc = libdeflate_crc32(crc, piece.data(), piece.size());
  }
  const auto check = big_endian_bytes(crc);
  bytes.insert(bytes.end(), check.begin(), check.end());
}

void append_text_chunk(std::vector<char>& bytes, std::string_view key, std::string_view text) {
  const std::string data = std::string(key) + '\0' + std::string(text);
  append_chunk(bytes, "tEXt", bytes_of_text(data));
}

}  // namespace morphcl
