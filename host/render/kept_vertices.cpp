#include "host/render/kept_vertices.hpp"

#include <algorithm>
#include <cstring>
#include <numeric>

namespace morphcl {

namespace {

using layout::uint;

template <class T>
bool same_bytes(const T& a, const T& b) {
  static_assert(std::is_trivially_copyable_v<T>);
  return std::memcmp(&a, &b, sizeof(T)) == 0;  // of 4-byte members without padding; -0 and 0 count as different
}

template <class T>
bool same_tables(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

}  // namespace

bool KeptVertices::same_view(const FrameTables& tables) const {
  return known_ && same_bytes(tables.frame, drawn_.frame);
}

bool KeptVertices::same_draw(const FrameTables& tables, std::size_t draw) const {
  if (draw >= drawn_.draws.size()) return false;
  layout::DrawConstants now = tables.draws[draw];
  const layout::DrawConstants& before = drawn_.draws[draw];
  const auto targets = tables.targets.begin() + now.first_target;
  const auto targets_before = drawn_.targets.begin() + before.first_target;
  now.first_target = before.first_target;
  now.first_position = before.first_position;
  return same_bytes(now, before) &&
         std::equal(targets, targets + now.target_count, targets_before, same_bytes<layout::TargetConstants>);
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
