#include "host/scene/gltf/gltf_container.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>

#include "host/scene/model/input_file.hpp"
#include "morphcl/error.hpp"

namespace morphcl {

namespace {

constexpr std::size_t header_size = 12, chunk_header_size = 8;
constexpr std::uint32_t json_chunk_type = 0x4E4F534A, binary_chunk_type = 0x004E4942;

std::uint32_t little_endian_32(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value |= std::uint32_t{static_cast<unsigned char>(bytes[at + i])} << (8 * i);
  return value;
}

constexpr std::uint8_t not_base64 = 255;

constexpr std::array<std::uint8_t, 256> base64_values() {
  std::array<std::uint8_t, 256> values{};
  values.fill(not_base64);
  constexpr std::string_view alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  for (std::size_t i = 0; i < alphabet.size(); ++i)
    values[static_cast<unsigned char>(alphabet[i])] = static_cast<std::uint8_t>(i);
  return values;
}

std::string decode_base64(std::string_view text, const std::string& place) {
  static constexpr std::array<std::uint8_t, 256> values = base64_values();
  for (int padding = 0; padding < 2 && !text.empty() && text.back() == '='; ++padding) text.remove_suffix(1);
  if (text.size() % 4 == 1) throw Error(ErrorKind::bad_input, place, "the base64 data is cut short");
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3 + 2);
  std::uint32_t bits = 0;
  int bit_count = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const std::uint8_t value = values[static_cast<unsigned char>(text[i])];
    if (value == not_base64)
      throw Error(ErrorKind::bad_input, place, fmt::format("character {} of the data is not base64", i));
    bits = (bits << 6 | value) & 0xFFFF;
    bit_count += 6;
    if (bit_count >= 8) {
      bit_count -= 8;
      bytes.push_back(static_cast<char>(bits >> bit_count & 0xFF));
    }
  }
  return bytes;
}

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

}  // namespace

GltfContainer split_gltf(std::string_view bytes, const std::string& file) {
  const auto fail = [&](std::string_view what) { throw Error(ErrorKind::bad_input, file, what); };
  if (bytes.substr(0, 4) != "glTF") {
    require_utf8(bytes, file);
    return {bytes, std::nullopt};
  }
  if (bytes.size() < header_size) fail("the header of the binary glTF file is cut short");
  if (const std::uint32_t version = little_endian_32(bytes, 4); version != 2)
    fail(fmt::format("binary glTF version {}; version 2 is read", version));
  if (const std::uint32_t length = little_endian_32(bytes, 8); length > bytes.size())
    fail(fmt::format("the header says {} bytes, the file has {}: it is truncated or damaged", length, bytes.size()));
  else
    bytes = bytes.substr(0, std::max<std::size_t>(length, header_size));

  GltfContainer parts;
  std::size_t at = header_size;
  for (int chunk = 0; at < bytes.size(); ++chunk) {
    if (bytes.size() - at < chunk_header_size) fail(fmt::format("the header of chunk {} is cut short", chunk));
    const std::uint32_t length = little_endian_32(bytes, at), type = little_endian_32(bytes, at + 4);
    at += chunk_header_size;
    if (length > bytes.size() - at)
      fail(fmt::format("chunk {} says {} bytes, {} are left: it is truncated or damaged", chunk, length,
                       bytes.size() - at));
    const std::string_view content = bytes.substr(at, length);
    at += length;
    if ((chunk == 0) != (type == json_chunk_type)) fail("the first chunk, and no other, must be the JSON chunk");
    if (chunk == 0) parts.json = content;
    if (type == binary_chunk_type) {
      if (chunk != 1) fail("the binary chunk must be the second one");
      parts.binary = content;
    }
  }
  if (parts.json.empty()) fail("the JSON chunk is missing or empty");
  return parts;
}

std::string decode_data_uri(std::string_view uri, const std::string& place) {
  const std::size_t comma = uri.find(',');
  if (comma == std::string_view::npos) throw Error(ErrorKind::bad_input, place, "a data URI must have a comma");
  const std::string_view content = uri.substr(comma + 1);
  return uri.substr(0, comma).ends_with(";base64") ? decode_base64(content, place) : decode_percent(content, place);
}

std::string decode_percent(std::string_view uri, const std::string& place) {
  std::string text;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    if (uri[i] != '%') {
      text.push_back(uri[i]);
      continue;
    }
    const int high = i + 2 < uri.size() ? hex_digit(uri[i + 1]) : -1;
    const int low = i + 2 < uri.size() ? hex_digit(uri[i + 2]) : -1;
    if (high < 0 || low < 0) throw Error(ErrorKind::bad_input, place, "a '%' must be followed by two hex digits");
    text.push_back(static_cast<char>(high * 16 + low));
    i += 2;
  }
  return text;
}

}  // namespace morphcl
