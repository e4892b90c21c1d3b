#include "host/render/device/kept_vertices.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <numeric>

namespace morphcl {

namespace {

using layout::uint;

// All members are 4 bytes wide; -0 and 0 count as different.
template <class T>
bool same_words(const T& a, const T& b) {
  using Words = std::array<uint, sizeof(T) / sizeof(uint)>;
  return std::bit_cast<Words>(a) == std::bit_cast<Words>(b);
}

template <class T>
bool same_tables(const std::vector<T>& a, const std::vector<T>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), same_words<T>);
}

bool is_precise(const layout::DrawConstants& draw) { return (draw.flags & (DRAW_PIVOT | DRAW_TWO_FLOAT)) != 0; }

}  // namespace

bool KeptVertices::same_view(const FrameTables& tables) const {
  return known_ && same_words(tables.frame, drawn_.frame);
}

bool KeptVertices::same_draw(const FrameTables& tables, std::size_t draw) const {
  if (draw >= drawn_.draws.size()) return false;
  layout::DrawConstants now = tables.draws[draw];
  const layout::DrawConstants& before = drawn_.draws[draw];
  const auto targets = tables.targets.begin() + now.first_target;
  const auto targets_before = drawn_.targets.begin() + before.first_target;
  now.first_target = before.first_target;
  now.first_position = before.first_position;
  if (is_precise(now) && is_precise(before) && !same_words(tables.precise[now.precise], drawn_.precise[before.precise]))
    return false;
  now.precise = before.precise;
  return same_words(now, before) && tables.displaced[draw] == drawn_.displaced[draw] &&
         std::equal(targets, targets + now.target_count, targets_before, same_words<layout::TargetConstants>);
}

std::vector<uint> KeptVertices::changed_chunks(const FrameTables& tables) const {
  const uint chunks = (tables.frame.group_count + layout::groups_per_chunk - 1) / layout::groups_per_chunk;
  std::vector<uint> changed;
  if (!same_view(tables)) {
    changed.resize(chunks);
    std::iota(changed.begin(), changed.end(), 0u);
    return changed;
  }
  for (std::size_t draw = 0; draw < tables.draws.size(); ++draw) {
    const layout::DrawConstants& constants = tables.draws[draw];
    if (constants.group_count == 0 || same_draw(tables, draw)) continue;
    const uint first = constants.first_group / layout::groups_per_chunk;
    const uint last = (constants.first_group + constants.group_count - 1) / layout::groups_per_chunk;
    for (uint chunk = changed.empty() ? first : std::max(first, changed.back() + 1); chunk <= last; ++chunk)
      changed.push_back(chunk);
  }
  return changed;
}

bool KeptVertices::faces_changed(const FrameTables& tables) const {
  if (!same_view(tables) || !same_tables(tables.lights, drawn_.lights)) return true;
  for (std::size_t draw = 0; draw < tables.draws.size(); ++draw)
    if (!same_draw(tables, draw)) return true;
  return false;
}

}  // namespace morphcl
