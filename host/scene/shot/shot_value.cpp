#include "host/scene/shot/shot_value.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "host/scene/shot/color_hint.hpp"
#include "host/scene/shot/key_hint.hpp"
#include "host/scene/shot/nearest_name.hpp"
#include "host/scene/shot/shot_coordinates.hpp"

namespace morphcl {

namespace {

std::string place_of(const std::string& file, int line, int column) {
  return fmt::format("{}:{}:{}", file, line, column);
}

std::string_view type_name(const TomlValue& value) {
  constexpr std::array<std::string_view, 7> names = {"true or false", "an integer", "a number", "a string",
                                                     "an array",      "a table",    "a date"};
  return names[value.data.index()];
}

}  // namespace

std::string ShotValue::place() const { return place_of(*file_, value_->line, value_->column); }

void ShotValue::fail(const std::string& message) const { throw Error(ErrorKind::bad_input, place(), message); }

void ShotValue::wrong_type(std::string_view needed) const {
  fail(fmt::format("{} is {}; {} is needed", name_, type_name(*value_), needed));
}

bool ShotValue::boolean() const {
  if (const bool* flag = std::get_if<bool>(&value_->data)) return *flag;
  wrong_type("true or false");
}

std::int64_t ShotValue::integer() const {
  if (const std::int64_t* integer = std::get_if<std::int64_t>(&value_->data)) return *integer;
  wrong_type("an integer");
}

std::optional<std::int64_t> ShotValue::integer_if_any() const {
  const std::int64_t* const integer = std::get_if<std::int64_t>(&value_->data);
  return integer ? std::optional(*integer) : std::nullopt;
}

double ShotValue::number_or_infinity() const {
  double number = 0;
  if (const std::int64_t* integer = std::get_if<std::int64_t>(&value_->data)) {
    number = static_cast<double>(*integer);
  } else if (const double* floating = std::get_if<double>(&value_->data)) {
    number = *floating;
  } else {
    wrong_type("a number");
  }
  if (std::isnan(number) || number == -INFINITY) fail(fmt::format("{} is {}; a number is needed", name_, number));
  return number;
}

double ShotValue::number() const {
  const double number = number_or_infinity();
  if (std::isinf(number)) fail(fmt::format("{} is inf; a finite number is needed", name_));
  return number;
}

double ShotValue::positive() const {
  const double value = number();
  if (!(value > 0)) fail(fmt::format("{} is {}; a number above 0 is needed", name_, value));
  return value;
}

double ShotValue::field_of_view() const {
  const double degrees = number();
  if (!(degrees > 0 && degrees < 180))
    fail(fmt::format("{} is {} degrees; more than 0 and less than 180 is needed", name_, degrees));
  return degrees;
}

const std::string& ShotValue::text() const {
  if (const std::string* text = std::get_if<std::string>(&value_->data)) return *text;
  wrong_type("a string");
}

bool ShotValue::choose(const char* no, const char* yes) const {
  if (text() != no && text() != yes)
    fail(fmt::format("unknown {} \"{}\"{}", name_, text(), suggestion(text(), {no, yes})));
  return text() == yes;
}

glm::dvec3 ShotValue::vector() const {
  if (!is_array() || size() != 3) fail(fmt::format("{} must be three numbers: [x, y, z]", name_));
  return {(*this)[0].number(), (*this)[1].number(), (*this)[2].number()};
}

glm::dvec3 ShotValue::point() const { return is_table() ? read_coordinates(*this) : vector(); }

glm::dvec3 ShotValue::factor() const { return is_number() ? glm::dvec3(number()) : vector(); }

glm::dvec3 ShotValue::color() const {
  refuse_color_text(*this);
  if (!is_array() || size() != 3) fail(fmt::format("{} must be three numbers: [red, green, blue]", name_));
  const glm::dvec3 color = vector();
  for (int c = 0; c < 3; ++c)
    if (color[c] < 0)
      (*this)[static_cast<std::size_t>(c)].fail(fmt::format("{} holds {}; 0 or more is needed", name_, color[c]));
  return color;
}

bool ShotValue::has(std::string_view key) const {
  const auto* const table = std::get_if<TomlValue::Table>(&value_->data);
  return table && std::ranges::any_of(*table, [key](const TomlEntry& entry) { return entry.key == key; });
}

std::size_t ShotValue::size() const {
  if (const auto* array = std::get_if<TomlValue::Array>(&value_->data)) return array->size();
  wrong_type("an array");
}

ShotValue ShotValue::operator[](std::size_t index) const {
  return {*file_, std::get<TomlValue::Array>(value_->data)[index], name_};
}

ShotTable ShotValue::table(std::initializer_list<std::string_view> known_keys) const { return {*this, known_keys}; }

ShotTable::ShotTable(const ShotValue& value, std::initializer_list<std::string_view> known_keys) : value_(value) {
  if (!value.is_table()) value.wrong_type("a table");
  for (const TomlEntry& entry : entries())
    if (std::find(known_keys.begin(), known_keys.end(), entry.key) == known_keys.end()) {
      const std::vector<std::string_view> known(known_keys);
      throw Error(ErrorKind::bad_input, place_of(*value.file_, entry.line, entry.column),
                  fmt::format("unknown key \"{}\" in {}{}", entry.key, value.name_, key_hint(entry.key, known)));
    }
}

std::optional<ShotValue> ShotTable::find(std::string_view key) const {
  const TomlValue::Table& table = entries();
  const auto entry = std::find_if(table.begin(), table.end(), [&](const TomlEntry& e) { return e.key == key; });
  if (entry == table.end()) return std::nullopt;
  return ShotValue(*value_.file_, entry->value, entry->key);
}

ShotValue ShotTable::need(std::string_view key) const {
  if (const auto value = find(key)) return *value;
  value_.fail(fmt::format("{} needs the key \"{}\"", value_.name(), key));
}

}  // namespace morphcl
