#include "host/scene/shot/nearest_name.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

namespace morphcl {

namespace {

constexpr std::size_t longest_compared = 64, max_compared = 1000, max_listed = 12;

// Optimal string alignment distance: Levenshtein's with swaps of neighbours.
std::size_t edits(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before_last(b.size() + 1), last(b.size() + 1), current(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) last[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    current[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replace = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      current[j] = std::min({replace, last[j] + 1, current[j - 1] + 1});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        current[j] = std::min(current[j], before_last[j - 2] + 1);
    }
    before_last.swap(last);
    last.swap(current);
  }
  return last[b.size()];
}

}  // namespace

std::string suggestion(std::string_view name, const std::vector<std::string_view>& candidates) {
  if (candidates.empty()) return "";
  std::string_view best;
  std::size_t fewest = longest_compared;
  for (std::size_t i = 0; i < std::min(candidates.size(), max_compared) && name.size() <= longest_compared; ++i) {
    const std::string_view candidate = candidates[i];
    if (candidate.size() > longest_compared) continue;
    const std::size_t distance = edits(name, candidate);
    if (distance < fewest && 3 * distance <= std::max(name.size(), candidate.size())) {
      best = candidate;
      fewest = distance;
    }
  }
  if (!best.empty()) return fmt::format("; did you mean \"{}\"?", best);
  const std::size_t listed = std::min(candidates.size(), max_listed);
  return fmt::format("; known: {}{}",
                     fmt::join(candidates.begin(), candidates.begin() + static_cast<std::ptrdiff_t>(listed), ", "),
                     candidates.size() > listed ? ", ..." : "");
}

}  // namespace morphcl
