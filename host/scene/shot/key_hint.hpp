// What may be meant by a key that does not exist: by what other tools call the same thing, or by its spelling.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace morphcl {

// `; did you mean "eye"?` for a name that other programs have for one of the known keys, with a word on the unit where
// theirs may be another one; else suggestion().
std::string key_hint(std::string_view key, const std::vector<std::string_view>& known);

}  // namespace morphcl
