#include "demos/viewer/key_script.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <string>

#include "morphcl/error.hpp"

namespace morphcl::viewer {
namespace {

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(' ');
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(' ') - first + 1);
}

[[noreturn]] void refuse(std::size_t number, std::string_view press, std::string_view what) {
  constexpr std::size_t shown = 40;
  throw Error(ErrorKind::usage, "--script",
              fmt::format("press {} \"{}\": {}", number, printable(press.substr(0, shown)), what));
}

std::string key_names() {
  std::string names;
  for (const KeyInfo& entry : key_table())
    if (!entry.name.empty()) names += fmt::format("{}{}", names.empty() ? "" : " ", entry.name);
  return names;
}

KeyPress parse_press(std::size_t number, std::string_view press) {
  const auto is_letter = [](unsigned char c) { return std::isalpha(c) != 0; };
  const auto name_end = std::ranges::find_if_not(press, is_letter);
  const std::string_view name(press.begin(), name_end);
  const std::string_view digits(name_end, press.end());

  std::optional<Key> key = find_key(name);
  if (key == Key::turn) key = Key::tick;
  if (!key) refuse(number, press, fmt::format("starts with no key; keys are {}", key_names()));
  if (digits.empty()) return {*key, 1};

  int count = 0;
  const auto [end, code] = std::from_chars(digits.data(), digits.data() + digits.size(), count);
  if (code != std::errc() || end != digits.data() + digits.size() || count < 1 || count > kMaxPresses) {
    refuse(number, press, fmt::format("the count after the key must be a whole number from 1 to {}", kMaxPresses));
  }
  return {*key, count};
}

}  // namespace

std::vector<KeyPress> parse_key_script(std::string_view text) {
  if (text.size() > kMaxScriptLength) {
    throw Error(ErrorKind::usage, "--script",
                fmt::format("the script has {} characters; at most {} are read", text.size(), kMaxScriptLength));
  }
  std::vector<KeyPress> script;
  int presses = 0;
  for (bool more = true; more;) {
    const std::size_t comma = text.find(',');
    const std::string_view press = trimmed(text.substr(0, comma));
    script.push_back(parse_press(script.size() + 1, press));
    presses += script.back().count;  // both at most kMaxPresses: no overflow
    if (presses > kMaxPresses) refuse(script.size(), press, fmt::format("more than {} presses in all", kMaxPresses));
    more = comma != std::string_view::npos;
    if (more) text.remove_prefix(comma + 1);
  }
  return script;
}

}  // namespace morphcl::viewer
