#include "lab/accuracy/text_rows.hpp"

#include <fmt/core.h>

#include <algorithm>

namespace morphcl::accuracy {

std::string aligned(const std::vector<TextRow>& rows, LastColumn last) {
  std::vector<std::size_t> widths(rows[0].size());
  std::vector<bool> filled(rows[0].size());
  for (std::size_t r = 0; r < rows.size(); ++r)
    for (std::size_t c = 0; c < rows[r].size(); ++c) {
      widths[c] = std::max(widths[c], rows[r][c].size());
      filled[c] = filled[c] || (r > 0 && !rows[r][c].empty());
    }
  std::string text;
  for (const TextRow& row : rows) {
    std::string line = "  ";
    for (std::size_t c = 0; c < row.size(); ++c) {
      if (!filled[c]) continue;
      const bool flush_left = c == 0 || (c + 1 == row.size() && last == LastColumn::words);
      if (c > 0) line += "  ";
      line += flush_left ? fmt::format("{:<{}}", row[c], widths[c]) : fmt::format("{:>{}}", row[c], widths[c]);
    }
    text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  return text;
}

}  // namespace morphcl::accuracy
