// One JSON object on one line, for programs that read the tool's output. Every object opens with "schema" and "type";
// fields keep the order in which they are added, and a later schema only adds fields.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace morphcl::cli {

class JsonLine {
 public:
  static constexpr int schema = 1;

  explicit JsonLine(std::string_view type);
  JsonLine& add(std::string_view key, std::string_view text);  // bytes that are not UTF-8 become U+FFFD
  JsonLine& add(std::string_view key, const char* text) { return add(key, std::string_view(text)); }
  JsonLine& add(std::string_view key, std::int64_t number);
  JsonLine& add(std::string_view key, int number) { return add(key, static_cast<std::int64_t>(number)); }
  JsonLine& add(std::string_view key, std::size_t number) { return add(key, static_cast<std::int64_t>(number)); }
  JsonLine& add(std::string_view key, double number);  // null when not finite
  JsonLine& add(std::string_view key, bool value);

  std::string str() const { return text_ + "}"; }

 private:
  JsonLine& add_raw(std::string_view key, std::string_view value);
  std::string text_;
};

}  // namespace morphcl::cli
