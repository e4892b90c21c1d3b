#include "host/render/plan/object_tree.hpp"

#include <algorithm>
#include <cmath>

#include "host/geometry/bounds.hpp"

namespace morphcl {

namespace {

constexpr std::size_t arity = 8;

// The lowest 10 bits, three places apart.
std::uint32_t spread(std::uint32_t v) {
  v = (v | v << 16) & 0x030000ffu;
  v = (v | v << 8) & 0x0300f00fu;
  v = (v | v << 4) & 0x030c30c3u;
  return (v | v << 2) & 0x09249249u;
}

std::uint32_t morton_code(const glm::dvec3& point, const Box& all) {
  std::uint32_t code = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double size = all.upper[axis] - all.lower[axis], from_lower = point[axis] - all.lower[axis];
    const double part = size > 0 && std::isfinite(size) ? from_lower / size : 0.0;
    code |= spread(static_cast<std::uint32_t>(std::clamp(part * 1024.0, 0.0, 1023.0))) << axis;
  }
  return code;
}

BoundedBox box_around(const BoundedBox* first, const BoundedBox* last) {
  Box box;
  glm::dvec3 magnitude(0.0);
  for (; first != last; ++first) {
    box.include(Box{first->center - first->half, first->center + first->half});
    magnitude = glm::max(magnitude, first->magnitude);
  }
  const glm::dvec3 half = 0.5 * box.upper - 0.5 * box.lower;
  // Half an ulp is lost where the centre is rounded.
  return {box.center(), half + 1e-15 * glm::max(glm::abs(box.lower), glm::abs(box.upper)), magnitude};
}

}  // namespace

ObjectTree::ObjectTree(const std::vector<std::optional<BoundedBox>>& bounds) : count_(bounds.size()) {
  Box centers;
  for (const auto& object : bounds)
    if (object) centers.include(object->center);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> along;  // code, object
  for (std::size_t i = 0; i < bounds.size(); ++i) {
    const auto object = static_cast<std::uint32_t>(i);
    if (bounds[i])
      along.emplace_back(morton_code(bounds[i]->center, centers), object);
    else
      anywhere_.push_back(object);
  }
  std::sort(along.begin(), along.end());
  if (along.empty()) return;

  std::vector<BoundedBox>& objects = levels_.emplace_back();
  for (const auto& [code, object] : along) {
    order_.push_back(object);
    objects.push_back(*bounds[object]);
  }
  while (levels_.back().size() > 1) {
    const std::vector<BoundedBox>& below = levels_.back();
    std::vector<BoundedBox> level;
    for (std::size_t at = 0; at < below.size(); at += arity)
      level.push_back(box_around(&below[at], &below[at] + std::min(arity, below.size() - at)));
    levels_.push_back(std::move(level));
  }
}

void ObjectTree::find(const HalfSpaces& view, InView& found) const {
  found.candidates.clear(count_);
  found.inside.clear(count_);
  for (const std::uint32_t object : anywhere_) found.candidates.insert(object);
  if (!levels_.empty()) visit(levels_.size() - 1, 0, view, found);
}

void ObjectTree::visit(std::size_t level, std::size_t at, const HalfSpaces& view, InView& found) const {
  const Side side = view.side(levels_[level][at]);
  if (side == Side::outside) return;
  if (side == Side::inside || level == 0) {
    std::size_t first = at, last = at + 1;
    for (std::size_t i = 0; i < level; ++i) {
      first *= arity;
      last *= arity;
    }
    for (std::size_t i = first; i < std::min(last, order_.size()); ++i) {
      found.candidates.insert(order_[i]);
      if (side == Side::inside) found.inside.insert(order_[i]);
    }
    return;
  }
  const std::size_t end = std::min(at * arity + arity, levels_[level - 1].size());
  for (std::size_t child = at * arity; child < end; ++child) visit(level - 1, child, view, found);
}

}  // namespace morphcl
