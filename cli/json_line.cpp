#include "cli/json_line.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

namespace morphcl::cli {

namespace {
std::string quoted(std::string_view text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}
}  // namespace

JsonLine::JsonLine(std::string_view type) : text_(fmt::format("{{\"schema\": {}", schema)) { add("type", type); }

JsonLine& JsonLine::add_raw(std::string_view key, std::string_view value) {
  text_ += fmt::format(", {}: {}", quoted(key), value);
  return *this;
}

JsonLine& JsonLine::add(std::string_view key, std::string_view text) { return add_raw(key, quoted(text)); }
JsonLine& JsonLine::add(std::string_view key, std::int64_t number) { return add_raw(key, fmt::to_string(number)); }
JsonLine& JsonLine::add(std::string_view key, double number) {
  return add_raw(key, std::isfinite(number) ? fmt::to_string(number) : "null");
}
JsonLine& JsonLine::add(std::string_view key, bool value) { return add_raw(key, value ? "true" : "false"); }

}  // namespace morphcl::cli
