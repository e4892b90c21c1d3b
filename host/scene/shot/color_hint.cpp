#include "host/scene/shot/color_hint.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <vector>

#include "host/math/fifth_root.hpp"

namespace morphcl {

namespace {

constexpr std::int64_t max_code = 255;
constexpr std::int64_t min_suspicious = 16;

// IEC 61966-2-1, to the four digits that are printed.
double linear_of(std::int64_t code) {
  const double value = static_cast<double>(code) / static_cast<double>(max_code);
  if (value <= 0.04045) return value / 12.92;
  const double base = (value + 0.055) / 1.055;
  const double root = fifth_root(base);
  return base * base * root * root;  // base^2.4
}

// R, G, B, and alpha, which has no curve.
std::string linear_array(const std::vector<std::int64_t>& codes) {
  std::string text;
  for (std::size_t c = 0; c < codes.size(); ++c)
    text +=
        fmt::format("{}{:.4g}", c == 0 ? "" : ", ", c < 3 ? linear_of(codes[c]) : static_cast<double>(codes[c]) / 255);
  return "[" + text + "]";
}

}  // namespace

std::optional<std::string> linear_of_hex(std::string_view text) {
  if (text.starts_with('#')) text.remove_prefix(1);
  const std::size_t digits = text.size() == 3 || text.size() == 4 ? 1 : 2;
  if (text.size() != 3 * digits && text.size() != 4 * digits) return std::nullopt;
  std::vector<std::int64_t> codes;
  for (std::size_t i = 0; i < text.size(); i += digits) {
    int code = 0;
    const auto [end, error] = std::from_chars(text.data() + i, text.data() + i + digits, code, 16);
    if (error != std::errc() || end != text.data() + i + digits || code < 0) return std::nullopt;
    codes.push_back(digits == 1 ? code * 17 : code);
  }
  return linear_array(codes);
}

void refuse_color_text(const ShotValue& color) {
  if (!color.is_text()) return;
  if (const auto linear = linear_of_hex(color.text()))
    color.fail(
        fmt::format("{} is \"{}\"; colours are three numbers, linear light: {}", color.name(), color.text(), *linear));
}

void refuse_codes(const ShotValue& color) {
  std::vector<std::int64_t> codes;
  for (std::size_t c = 0; c < color.size(); ++c) {
    const std::optional<std::int64_t> code = color[c].integer_if_any();
    if (!code || *code < 0 || *code > max_code) return;
    codes.push_back(*code);
  }
  const auto largest = std::max_element(codes.begin(), codes.end());
  if (largest == codes.end() || *largest < min_suspicious) return;
  color[static_cast<std::size_t>(largest - codes.begin())].fail(fmt::format(
      "{} holds {}; colours are linear light, 1 is white: sRGB [{}] of 255 is {}; write {}.0 if it is meant",
      color.name(), *largest, fmt::join(codes, ", "), linear_array(codes), *largest));
}

}  // namespace morphcl
