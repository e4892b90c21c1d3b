// Rows of text with their columns one below the other.
#pragma once

#include <string>
#include <vector>

namespace morphcl::accuracy {

using TextRow = std::vector<std::string>;

// One line a row, all rows as long as the first, which has the headings. Columns that no other row fills are left out;
// the first is flush left, and the last where it is words, the others flush right.
enum class LastColumn { numbers, words };
std::string aligned(const std::vector<TextRow>& rows, LastColumn last = LastColumn::numbers);

}  // namespace morphcl::accuracy
