#include "host/scene/obj/obj_text.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace morphcl {

namespace {

constexpr std::string_view blanks = " \t\v\f";

std::string_view trim(std::string_view text) {
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::string_view take_word(std::string_view& text) {
  text = text.substr(std::min(text.find_first_not_of(blanks), text.size()));
  const std::string_view word = text.substr(0, text.find_first_of(blanks));
  text.remove_prefix(word.size());
  return word;
}

// Names may hold a '#'.
std::string_view without_comment(std::string_view line) {
  std::size_t hash = line.find('#');
  while (hash != std::string_view::npos && hash > 0 && blanks.find(line[hash - 1]) == std::string_view::npos)
    hash = line.find('#', hash + 1);
  return line.substr(0, hash);
}

std::string_view without_plus(std::string_view word) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  return word;
}

// Whether a number that fp32 cannot hold is too small rather than too large: by the decimal exponent of its first digit
// that is not 0. The word has been accepted as a number.
bool is_tiny(std::string_view word) {
  const std::size_t e = std::min(word.find_first_of("eE"), word.size());
  const std::string_view mantissa = word.substr(0, e);
  const std::size_t point = std::min(mantissa.find('.'), mantissa.size());
  const std::size_t digit = mantissa.find_first_of("123456789");
  if (digit == std::string_view::npos) return true;
  std::int64_t exponent = static_cast<std::int64_t>(point) - static_cast<std::int64_t>(digit);
  if (e < word.size()) {
    const std::string_view digits = without_plus(word.substr(e + 1));
    std::int64_t written = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), written);
    if (error == std::errc::result_out_of_range) return digits[0] == '-';
    constexpr std::int64_t far = 1'000'000'000'000;  // beyond the length of any word, and safe to add
    exponent += std::clamp(written, -far, far);
  }
  return exponent < 0;
}

}  // namespace

ObjStatements::ObjStatements(std::string_view text) : rest_(text) {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (rest_.starts_with(byte_order_mark)) rest_.remove_prefix(byte_order_mark.size());
}

std::string_view ObjStatements::take_line() {
  const std::size_t end = std::min(rest_.find_first_of("\n\r"), rest_.size());
  const std::string_view line = rest_.substr(0, end);
  const bool crlf = end + 1 < rest_.size() && rest_[end] == '\r' && rest_[end + 1] == '\n';
  rest_.remove_prefix(std::min(end + (crlf ? 2 : 1), rest_.size()));
  ++lines_taken_;
  return without_comment(line);
}

bool ObjStatements::next() {
  while (!rest_.empty()) {
    line_ = lines_taken_ + 1;
    words_ = take_line();
    if (words_.ends_with('\\')) {
      joined_.clear();
      while (words_.ends_with('\\')) {
        joined_ += words_.substr(0, words_.size() - 1);
        joined_ += ' ';
        words_ = rest_.empty() ? std::string_view{} : take_line();
      }
      joined_ += words_;
      words_ = joined_;
    }
    keyword_ = take_word(words_);
    if (!keyword_.empty()) return true;
  }
  return false;
}

std::string_view ObjStatements::word() { return take_word(words_); }

std::string_view ObjStatements::remainder() const { return trim(words_); }

std::optional<float> parse_float(std::string_view word) {
  word = without_plus(word);
  const char* end = word.data() + word.size();
  float value = 0;
  const auto [stop, error] = std::from_chars(word.data(), end, value);
  if (stop != end || word.empty()) return std::nullopt;
  if (error == std::errc::result_out_of_range) {
    if (!is_tiny(word)) return std::nullopt;
    return word[0] == '-' ? -0.0f : 0.0f;
  }
  if (error != std::errc() || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::optional<std::int64_t> parse_integer(std::string_view word) {
  word = without_plus(word);
  const char* end = word.data() + word.size();
  std::int64_t value = 0;
  const auto [stop, error] = std::from_chars(word.data(), end, value);
  if (stop != end || word.empty() || error != std::errc()) return std::nullopt;
  return value;
}

}  // namespace morphcl
