// A TOML file as a tree of values that know their place in the text. Only toml_document.cpp knows the TOML library.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace morphcl {

struct TomlEntry;

struct TomlValue {
  using Array = std::vector<TomlValue>;
  using Table = std::vector<TomlEntry>;  // sorted by key; each key once
  struct Date {};                        // a date or time: no shot file needs one

  std::variant<bool, std::int64_t, double, std::string, Array, Table, Date> data;
  int line = 1, column = 1;  // where the value starts, counted from 1
};

struct TomlEntry {
  std::string key;
  int line = 1, column = 1;  // of the key
  TomlValue value;
};

constexpr std::uint64_t max_toml_bytes = std::uint64_t{8} << 20;

// The root table of `text`. Error(bad_input) at "file:line:column" for a syntax error, text longer than max_toml_bytes,
// a dotted key of more than 8 parts, or values nested deeper than 64.
TomlValue parse_toml(std::string_view text, const std::string& file);

}  // namespace morphcl
