#pragma once

#include <algorithm>
#include <filesystem>
#include <string>
#include <string_view>

namespace morphcl {

// Of the letters A to Z alone, whatever the locale.
inline std::string lower_case(std::string_view text) {
  std::string lower(text);
  std::ranges::for_each(lower, [](char& c) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  });
  return lower;
}

// ".obj" of "a/Pot.OBJ".
inline std::string lower_case_extension(const std::filesystem::path& path) {
  return lower_case(path.extension().string());
}

}  // namespace morphcl
