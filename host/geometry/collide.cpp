#include <algorithm>
#include <cstddef>
#include <utility>

#include "morphcl/collision.hpp"

namespace morphcl {

namespace {

bool boxes_meet(const Box& a, const Box& b) {
  return a.lower.x <= b.upper.x && b.lower.x <= a.upper.x && a.lower.y <= b.upper.y && b.lower.y <= a.upper.y &&
         a.lower.z <= b.upper.z && b.lower.z <= a.upper.z;
}

Box box_of_triangle(const Triangle& triangle) {
  Box box;
  for (const glm::dvec3& corner : triangle) box.include(corner);
  return box;
}

// Every pair of leaves whose boxes meet; of two nodes the one with more triangles below, the larger box, is opened.
template <class Visit>
void for_each_pair_of_leaves(const MeshTree& a, const MeshTree& b, Visit visit) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> open;
  if (a.size() > 0 && b.size() > 0) open.emplace_back(0, 0);
  while (!open.empty()) {
    const auto [i, j] = open.back();
    open.pop_back();
    const MeshTree::Node &p = a.nodes()[i], &q = b.nodes()[j];
    if (!boxes_meet(p.box, q.box)) continue;
    if (p.count > 0 && q.count > 0) {
      visit(p, q);
      continue;
    }
    const auto size = [](const Box& box) { return box.upper - box.lower; };
    const glm::dvec3 of_p = size(p.box), of_q = size(q.box);
    const bool open_first = q.count > 0 || (p.count == 0 && of_p.x + of_p.y + of_p.z >= of_q.x + of_q.y + of_q.z);
    if (open_first) {
      open.emplace_back(i + 1, j);
      open.emplace_back(p.right, j);
    } else {
      open.emplace_back(i, j + 1);
      open.emplace_back(i, q.right);
    }
  }
}

// Of surfaces that are apart each part lies inside or outside as a whole.
bool has_part_inside(const MeshTree& of, const MeshTree& mesh) {
  if (!mesh.closed()) return false;
  const auto inside = [&](const glm::dvec3& corner) { return place_in_mesh(mesh, corner) == PointPlace::inside; };
  return std::any_of(of.part_corners().begin(), of.part_corners().end(), inside);
}

}  // namespace

Collision collide(const MeshTree& a, const MeshTree& b, std::size_t max_pairs) {
  Collision result;
  for_each_pair_of_leaves(a, b, [&](const MeshTree::Node& p, const MeshTree::Node& q) {
    for (std::uint32_t i = p.first; i < p.first + p.count; ++i) {
      const Triangle of_a = a.triangle(a.order()[i]);
      const Box box = box_of_triangle(of_a);
      if (!boxes_meet(box, q.box)) continue;
      for (std::uint32_t j = q.first; j < q.first + q.count; ++j) {
        const Triangle of_b = b.triangle(b.order()[j]);
        if (!boxes_meet(box, box_of_triangle(of_b))) continue;
        const Contact found = contact(of_a, of_b);
        if (found == Contact::apart) continue;
        result.contact = std::max(result.contact, found);
        result.pairs.push_back({a.order()[i], b.order()[j], found, {}});
      }
    }
  });
  result.count = result.pairs.size();
  std::sort(result.pairs.begin(), result.pairs.end(), [](const TriangleContact& p, const TriangleContact& q) {
    return std::pair(p.a, p.b) < std::pair(q.a, q.b);
  });
  result.pairs.resize(std::min(max_pairs, result.pairs.size()));
  for (TriangleContact& pair : result.pairs) pair.points = common_points(a.triangle(pair.a), b.triangle(pair.b));
  if (result.contact == Contact::apart) {
    result.a_in_b = has_part_inside(a, b);
    result.b_in_a = has_part_inside(b, a);
  }
  return result;
}

}  // namespace morphcl
