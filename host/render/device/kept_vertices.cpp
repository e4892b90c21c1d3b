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

bool same_view(const FrameTables& now, const FrameTables* before) {
  return before && same_words(now.frame, before->frame);
}

bool same_draw(const FrameTables& now, const FrameTables& before, std::size_t index) {
  if (index >= before.draws.size()) return false;
  layout::DrawConstants draw = now.draws[index];
  const layout::DrawConstants& old = before.draws[index];
  const auto targets = now.targets.begin() + draw.first_target, old_targets = before.targets.begin() + old.first_target;
  if (is_precise(draw) && is_precise(old) && !same_words(now.precise[draw.precise], before.precise[old.precise]))
    return false;
  // Where the tables have them is another matter.
  draw.first_target = old.first_target;
  draw.first_in_order = old.first_in_order;
  draw.precise = old.precise;
  return same_words(draw, old) && now.displaced[index] == before.displaced[index] &&
         std::equal(targets, targets + draw.target_count, old_targets, same_words<layout::TargetConstants>);
}

}  // namespace

std::vector<uint> changed_vertex_chunks(const FrameTables& now, const FrameTables* before) {
  constexpr uint in_chunk = layout::vertex_groups_per_chunk;
  std::vector<uint> changed;
  if (!same_view(now, before)) {
    changed.resize((now.frame.vertex_group_count + in_chunk - 1) / in_chunk);
    std::iota(changed.begin(), changed.end(), 0u);
    return changed;
  }
  for (std::size_t i = 0; i < now.draws.size(); ++i) {
    const layout::DrawConstants& draw = now.draws[i];
    if (draw.vertex_group_count == 0 || same_draw(now, *before, i)) continue;
    const uint first = draw.first_vertex_group / in_chunk;
    const uint last = (draw.first_vertex_group + draw.vertex_group_count - 1) / in_chunk;
    for (uint chunk = changed.empty() ? first : std::max(first, changed.back() + 1); chunk <= last; ++chunk)
      changed.push_back(chunk);
  }
  return changed;
}

bool faces_changed(const FrameTables& now, const FrameTables* before) {
  if (!same_view(now, before) || !same_tables(now.lights, before->lights)) return true;
  for (std::size_t i = 0; i < now.draws.size(); ++i)
    if (!same_draw(now, *before, i)) return true;
  return false;
}

}  // namespace morphcl
