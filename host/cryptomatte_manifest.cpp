#include "host/cryptomatte_manifest.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <string_view>
#include <unordered_set>

#include "host/cryptomatte_id.hpp"

namespace morphcl {

namespace {

// Bytes of the UTF-8 character at the text's beginning; 0 where there is none (RFC 3629: no overlong forms, no
// surrogates, none above U+10FFFF).
std::size_t utf8_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(i < text.size() ? text[i] : 0); };
  const auto follows = [&](std::size_t i) { return (byte(i) & 0xc0) == 0x80; };
  const unsigned first = byte(0), second = byte(1);
  if (first < 0x80) return 1;
  if (first < 0xc2 || first > 0xf4 || !follows(1)) return 0;
  if (first < 0xe0) return 2;
  if (!follows(2)) return 0;
  if (first < 0xf0) return (first == 0xe0 && second < 0xa0) || (first == 0xed && second > 0x9f) ? 0 : 3;
  return !follows(3) || (first == 0xf0 && second < 0x90) || (first == 0xf4 && second > 0x8f) ? 0 : 4;
}

std::string json_text(std::string_view text) {
  std::string json = "\"";
  while (!text.empty()) {
    const std::size_t length = utf8_length(text);
    const auto first = static_cast<unsigned char>(text[0]);
    if (length == 0)
      json += "\\ufffd";
    else if (first == '"' || first == '\\')
      json += {'\\', text[0]};
    else if (first < 0x20)
      json += fmt::format("\\u{:04x}", first);
    else
      json += text.substr(0, length);
    text.remove_prefix(length == 0 ? 1 : length);
  }
  return json + '"';
}

}  // namespace

std::string cryptomatte_manifest(std::span<const std::string> names) {
  std::string json = "{";
  std::unordered_set<std::string_view> seen;
  for (const std::string& name : names)
    if (seen.insert(name).second)
      json += fmt::format("{}{}:\"{:08x}\"", json.size() > 1 ? "," : "", json_text(name), cryptomatte_bits(name));
  return json + "}";
}

}  // namespace morphcl
