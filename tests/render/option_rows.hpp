// What a picture may be asked for: every combination, few that have every pair of values, or fewer that have every
// value.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "morphcl/scene.hpp"

namespace morphcl::test {

// The values of each option, by their numbers.
constexpr std::array<int, 7> option_values = {5, 5, 6, 2, 3, 2, 2};
using OptionRow = std::array<int, option_values.size()>;

std::vector<OptionRow> all_option_rows();
// Chosen from all rows one by one, each time the first of those that have most of what is still missing: sets of
// `strength` options, 1 or 2, with their values.
std::vector<OptionRow> covering_option_rows(int strength);

// "samples 4, fixed24, RGBA Z, background, blend, lines, precise".
std::string words_for(const OptionRow& row);
Scene with_options(Scene scene, const OptionRow& row);

}  // namespace morphcl::test
