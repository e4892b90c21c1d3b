// Suggestions for names that do not exist.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace morphcl {

// `; did you mean "x"?` for the candidate with the fewest edits (insert, delete, replace, swap of neighbours), when
// they are at most a third of the longer name's letters; else `; known: a, b, c` (the first twelve); empty without
// candidates.
std::string suggestion(std::string_view name, const std::vector<std::string_view>& candidates);

}  // namespace morphcl
