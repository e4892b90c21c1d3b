#include "host/scene/model/model_choice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "morphcl/error.hpp"

namespace morphcl {

std::string numbered(const std::vector<std::string>& names) {
  constexpr std::size_t told = 12, told_name = 60;
  std::string text;
  for (std::size_t i = 0; i < std::min(names.size(), told); ++i)
    text += fmt::format("{}{} '{}'", i > 0 ? ", " : "", i, printable(names[i].substr(0, told_name)));
  if (names.size() > told) text += fmt::format(" and {} more", names.size() - told);
  return text;
}

std::size_t choose(const std::vector<std::string>& names, const std::string& wanted, std::string_view what,
                   const std::string& file) {
  const auto named = std::find(names.begin(), names.end(), wanted);
  if (named != names.end()) return static_cast<std::size_t>(named - names.begin());
  std::size_t index = 0;
  const auto [end, error] = std::from_chars(wanted.data(), wanted.data() + wanted.size(), index);
  if (error == std::errc() && end == wanted.data() + wanted.size() && index < names.size()) return index;
  throw Error(ErrorKind::usage, file,
              fmt::format("there is no {} '{}'; {}", what, printable(wanted.substr(0, 60)),
                          names.empty() ? "the file has none" : "the file has " + numbered(names)));
}

}  // namespace morphcl
