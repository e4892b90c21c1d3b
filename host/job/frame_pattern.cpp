#include "host/job/frame_pattern.hpp"

#include <fmt/format.h>

#include <optional>
#include <string_view>

#include "morphcl/error.hpp"

namespace morphcl {

namespace {

constexpr int max_digits = 20;
constexpr int digits_of_lone_hash = 4;

struct Place {
  std::size_t begin, length;
  int digits;
};

bool is_digit(char c) { return c >= '0' && c <= '9'; }

// %d or %0Nd at `begin`; what else follows a '%' is part of the name.
std::optional<Place> percent_place(std::string_view name, std::size_t begin) {
  std::size_t end = begin + 1;
  int digits = 0;
  if (end < name.size() && name[end] == '0')
    for (++end; end < name.size() && is_digit(name[end]) && digits <= max_digits; ++end)
      digits = digits * 10 + (name[end] - '0');
  if (end >= name.size() || name[end] != 'd') return std::nullopt;
  return Place{begin, end + 1 - begin, digits};
}

std::optional<Place> next_place(std::string_view name, std::size_t from) {
  for (std::size_t i = from; i < name.size(); ++i) {
    if (name[i] == '#') {
      const std::size_t end = std::min(name.find_first_not_of('#', i), name.size());
      const std::size_t count = end - i;
      const int digits = count == 1                                     ? digits_of_lone_hash
                         : count > static_cast<std::size_t>(max_digits) ? max_digits + 1
                                                                        : static_cast<int>(count);
      return Place{i, count, digits};
    }
    if (name[i] == '%')
      if (const auto place = percent_place(name, i)) return place;
  }
  return std::nullopt;
}

}  // namespace

FramePattern::FramePattern(const std::string& pattern) : before_(pattern) {
  const std::size_t slash = pattern.rfind('/');
  const std::size_t name = slash == std::string::npos ? 0 : slash + 1;
  if (name == pattern.size())
    throw Error(ErrorKind::usage, "",
                fmt::format("the output '{}' has no file name; as in out/frame.####.exr", pattern));
  const auto place = next_place(pattern, name);
  if (!place) return;
  if (next_place(pattern, place->begin + place->length))
    throw Error(ErrorKind::usage, "",
                fmt::format("the output '{}' has more than one place for the frame number; keep one of them", pattern));
  if (place->digits > max_digits)
    throw Error(ErrorKind::usage, "", fmt::format("the output '{}' asks for more than {} digits", pattern, max_digits));
  before_ = pattern.substr(0, place->begin);
  after_ = pattern.substr(place->begin + place->length);
  digits_ = place->digits;
  has_number_ = true;
}

std::string FramePattern::path(std::int64_t frame) const {
  if (!has_number_) return before_;
  return fmt::format("{}{:0{}}{}", before_, frame, digits_, after_);  // the sign counts, as in printf
}

}  // namespace morphcl
