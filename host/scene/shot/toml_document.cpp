#include "host/scene/shot/toml_document.hpp"

#include <fmt/format.h>

#include <cstddef>

#include "morphcl/error.hpp"

// The library (3.3) asserts, and with Clang's NDEBUG assumes, conditions that malformed text breaks, and then checks
// them once more to report an error. Without the assertions the checks decide, in every build.
#undef NDEBUG
#define TOML_ASSERT(condition) static_cast<void>(0)
#include <toml++/toml.h>

namespace morphcl {

namespace {

constexpr int max_key_parts = 8, max_depth = 64;

[[noreturn]] void fail(const std::string& file, std::int64_t line, std::int64_t column, const std::string& message) {
  throw Error(ErrorKind::bad_input, fmt::format("{}:{}:{}", file, line, column), message);
}

// The library takes dotted keys of any length and frees the tables they make by recursion, so a hostile line could
// exhaust the stack. This scan, which knows strings and comments and nothing else, refuses such keys before the library
// sees them.
class KeyDepthScan {
 public:
  KeyDepthScan(std::string_view text, const std::string& file) : text_(text), file_(file) {}

  void run() {
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (c == '"' || c == '\'') {
        skip_string(c);
      } else if (c == '#') {
        skip_until('\n');
      } else {
        count(c);
        advance();
      }
    }
  }

 private:
  void advance() {
    if (text_[at_] == '\n') {
      ++line_;
      line_start_ = at_ + 1;
    }
    ++at_;
  }
  void skip_until(char end) {
    while (at_ < text_.size() && text_[at_] != end) advance();
  }
  bool at_triple(char quote) const { return text_.substr(at_, 3) == std::string(3, quote); }

  void skip_string(char quote) {
    const bool triple = at_triple(quote);
    const std::size_t quotes = triple ? 3 : 1;
    for (std::size_t i = 0; i < quotes; ++i) advance();
    while (at_ < text_.size()) {
      if (triple ? at_triple(quote) : text_[at_] == quote) {
        for (std::size_t i = 0; i < quotes; ++i) advance();
        return;
      }
      if (!triple && text_[at_] == '\n') return;  // an unclosed string: the library reports it
      if (quote == '"' && text_[at_] == '\\' && at_ + 1 < text_.size()) advance();
      advance();
    }
  }

  void count(char c) {
    if (c == '.') {
      if (++dots_ >= max_key_parts)
        fail(file_, line_, static_cast<std::int64_t>(at_ - line_start_) + 1,
             fmt::format("a key of more than {} parts", max_key_parts));
    } else if (c == '=' || c == ',' || c == '[' || c == ']' || c == '{' || c == '}' || c == '\n') {
      dots_ = 0;
    }
  }

  std::string_view text_;
  const std::string& file_;
  std::size_t at_ = 0, line_start_ = 0;
  std::int64_t line_ = 1;
  int dots_ = 0;
};

TomlValue convert(const toml::node& node, const std::string& file, int depth) {
  TomlValue value;
  const toml::source_position place = node.source().begin;
  if (place) {
    value.line = static_cast<int>(place.line);
    value.column = static_cast<int>(place.column);
  }
  if (depth > max_depth) fail(file, value.line, value.column, fmt::format("values nested deeper than {}", max_depth));
  if (const auto* flag = node.as_boolean()) {
    value.data = flag->get();
  } else if (const auto* integer = node.as_integer()) {
    value.data = integer->get();
  } else if (const auto* number = node.as_floating_point()) {
    value.data = number->get();
  } else if (const auto* text = node.as_string()) {
    value.data = text->get();
  } else if (const auto* array = node.as_array()) {
    TomlValue::Array elements;
    elements.reserve(array->size());
    for (const toml::node& element : *array) elements.push_back(convert(element, file, depth + 1));
    value.data = std::move(elements);
  } else if (const auto* table = node.as_table()) {
    TomlValue::Table entries;
    entries.reserve(table->size());
    for (const auto& [key, element] : *table) {
      const toml::source_position key_place = key.source().begin;
      entries.push_back({std::string(key.str()), static_cast<int>(key_place.line), static_cast<int>(key_place.column),
                         convert(element, file, depth + 1)});
    }
    value.data = std::move(entries);
  } else {
    value.data = TomlValue::Date{};
  }
  return value;
}

}  // namespace

TomlValue parse_toml(std::string_view text, const std::string& file) {
  if (text.size() > max_toml_bytes)
    throw Error(ErrorKind::bad_input, file,
                fmt::format("{} bytes of TOML; at most {} are read", text.size(), max_toml_bytes));
  KeyDepthScan(text, file).run();
  try {
    const toml::table root = toml::parse(text);
    return convert(root, file, 0);
  } catch (const toml::parse_error& error) {
    const toml::source_position place = error.source().begin;
    fail(file, place.line, place.column, std::string(error.description()));
  }
}

}  // namespace morphcl
