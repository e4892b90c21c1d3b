#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <utility>

#include "host/geometry/triangle_contact.hpp"
#include "host/math/finite.hpp"
#include "morphcl/collision.hpp"
#include "morphcl/error.hpp"

namespace morphcl {

namespace {

// The ends lie on different sides of the triangle, and the segment passes all its edges on one side.
bool runs_through(const Segment3& segment, const Triangle& triangle) {
  const auto side = [&](const glm::dvec3& end) { return orientation(triangle[0], triangle[1], triangle[2], end); };
  if (side(segment.from) * side(segment.to) >= 0) return false;
  int sum = 0;
  for (std::size_t i = 0; i < 3; ++i) sum += orientation(segment.from, segment.to, triangle[i], triangle[(i + 1) % 3]);
  return std::abs(sum) == 3;
}

// By a sum of three differences, halved against overflow: along a segment it grows as the distance does.
double distance_along(const Segment3& segment, const glm::dvec3& point) {
  const glm::dvec3 off = glm::abs(0.25 * point - 0.25 * segment.from);
  return off.x + off.y + off.z;
}

}  // namespace

std::vector<MeshHit> intersect(const Segment3& segment, const MeshTree& mesh) {
  if (!is_finite(segment.from) || !is_finite(segment.to))
    throw Error(ErrorKind::usage, "", "a coordinate is not finite; give numbers");
  Box around;
  around.include(segment.from);
  around.include(segment.to);
  std::vector<MeshHit> hits;
  std::vector<std::uint32_t> open;
  if (!mesh.nodes().empty()) open.push_back(0);
  while (!open.empty()) {
    const std::uint32_t index = open.back();
    const MeshTree::Node& node = mesh.nodes()[index];
    open.pop_back();
    if (contact(around, node.box) == Contact::apart || intersect(segment, node.box).contact == Contact::apart) continue;
    if (node.count == 0) {
      open.push_back(index + 1);
      open.push_back(node.right);
    }
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      const Triangle triangle = mesh.triangle(mesh.order()[i]);
      if (!segment_meets_triangle(segment, triangle)) continue;
      const std::vector<glm::dvec3> points = common_points({segment.from, segment.to, segment.to}, triangle);
      MeshHit hit{mesh.order()[i], {Contact::touching, points.front(), points.back()}};
      if (runs_through(segment, triangle)) hit.at.contact = Contact::crossing;
      if (distance_along(segment, hit.at.to) < distance_along(segment, hit.at.from)) std::swap(hit.at.from, hit.at.to);
      hits.push_back(hit);
    }
  }
  std::sort(hits.begin(), hits.end(), [&](const MeshHit& a, const MeshHit& b) {
    return std::pair(distance_along(segment, a.at.from), a.triangle) <
           std::pair(distance_along(segment, b.at.from), b.triangle);
  });
  return hits;
}

}  // namespace morphcl
