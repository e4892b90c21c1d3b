// Values of a shot file, read with checks: every failure is Error(bad_input) at "file:line:column".
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>

#include "host/scene/shot/toml_document.hpp"
#include "morphcl/error.hpp"

namespace morphcl {

class ShotTable;

// A value, the name that errors call it by, and the file it stands in. It refers to the document, which must outlive
// it.
class ShotValue {
 public:
  ShotValue(const std::string& file, const TomlValue& value, std::string_view name)
      : file_(&file), value_(&value), name_(name) {}

  std::string_view name() const { return name_; }
  std::string place() const;
  [[noreturn]] void fail(const std::string& message) const;

  bool boolean() const;
  std::int64_t integer() const;
  std::optional<std::int64_t> integer_if_any() const;  // nothing where it is something else
  double number() const;                               // finite; an integer is a number
  double number_or_infinity() const;                   // finite or +inf
  double positive() const;                             // finite and > 0
  double field_of_view() const;                        // degrees: more than 0 and less than 180
  const std::string& text() const;
  bool choose(const char* no, const char* yes) const;  // the text is one of the two: whether it is `yes`
  glm::dvec3 vector() const;                           // [x, y, z]
  glm::dvec3 point() const;                            // [x, y, z] or other coordinates (shot_coordinates.hpp)
  glm::dvec3 factor() const;                           // [x, y, z], or one number for all three
  glm::dvec3 color() const;                            // [r, g, b], each >= 0
  bool is_array() const { return std::holds_alternative<TomlValue::Array>(value_->data); }
  bool is_table() const { return std::holds_alternative<TomlValue::Table>(value_->data); }
  bool is_number() const {
    return std::holds_alternative<std::int64_t>(value_->data) || std::holds_alternative<double>(value_->data);
  }
  bool is_text() const { return std::holds_alternative<std::string>(value_->data); }
  bool is_boolean() const { return std::holds_alternative<bool>(value_->data); }

  bool has(std::string_view key) const;                                       // whether it is a table with the key
  std::size_t size() const;                                                   // of an array
  ShotValue operator[](std::size_t index) const;                              // of an array; bears the array's name
  ShotTable table(std::initializer_list<std::string_view> known_keys) const;  // refuses any other key

 private:
  friend class ShotTable;
  [[noreturn]] void wrong_type(std::string_view needed) const;

  const std::string* file_;
  const TomlValue* value_;
  std::string_view name_;
};

class ShotTable {
 public:
  ShotTable(const ShotValue& value, std::initializer_list<std::string_view> known_keys);

  const ShotValue& value() const { return value_; }
  std::optional<ShotValue> find(std::string_view key) const;
  ShotValue need(std::string_view key) const;
  bool has(std::string_view key) const { return find(key).has_value(); }
  // Calls visit(ShotValue) for each table of the array of tables `key`; none when the key is missing.
  template <typename Visit>
  void for_each(std::string_view key, Visit&& visit) const {
    const std::optional<ShotValue> list = find(key);
    if (!list) return;
    if (list->is_table()) list->fail(std::string(key) + " is one table; several are possible, so write it with [[ ]]");
    for (std::size_t i = 0; i < list->size(); ++i) visit((*list)[i]);
  }
  // The place and value of each key, in alphabetical order.
  const TomlValue::Table& entries() const { return std::get<TomlValue::Table>(value_.value_->data); }

 private:
  ShotValue value_;
};

// Runs `action`; an Error without a place that it throws becomes Error(bad_input) at the place of `value`.
template <typename Action>
auto placed_at(const ShotValue& value, Action&& action) {
  try {
    return action();
  } catch (const Error& error) {
    if (!error.place().empty()) throw;
    value.fail(error.message());
  }
}

}  // namespace morphcl
