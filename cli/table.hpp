// Aligned columns of text for people.
#pragma once

#include <string>
#include <vector>

namespace morphcl::cli {

// One string a row, columns padded to the widest cell and two spaces apart; no trailing spaces. Rows may be ragged.
std::vector<std::string> aligned(const std::vector<std::vector<std::string>>& rows);

}  // namespace morphcl::cli
