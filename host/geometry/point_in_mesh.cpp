#include <array>

#include "host/geometry/exact_space.hpp"
#include "host/geometry/triangle_contact.hpp"
#include "host/math/finite.hpp"
#include "morphcl/collision.hpp"
#include "morphcl/error.hpp"

namespace morphcl {

namespace {

// What a ray from the point towards larger x may meet.
bool may_meet_ray(const Box& box, const glm::dvec3& point) {
  return point.x <= box.upper.x && point.y >= box.lower.y && point.y <= box.upper.y && point.z >= box.lower.z &&
         point.z <= box.upper.z;
}

}  // namespace

// The ray counts the triangles that it runs through, each the way it faces. Seen along the ray they are triangles of a
// plane whose edges are half-open, so that an edge or a corner that several share is counted as it must be.
PointPlace place_in_mesh(const MeshTree& mesh, const glm::dvec3& point) {
  if (!mesh.closed())
    throw Error(ErrorKind::usage, "",
                "the mesh is not closed and has no inside; close it, or face its triangles one way");
  if (!is_finite(point)) throw Error(ErrorKind::usage, "", "a coordinate is not finite; give numbers");
  int winding = 0;
  std::vector<std::uint32_t> open;
  if (!mesh.nodes().empty()) open.push_back(0);
  while (!open.empty()) {
    const std::uint32_t index = open.back();
    const MeshTree::Node& node = mesh.nodes()[index];
    open.pop_back();
    if (!may_meet_ray(node.box, point)) continue;
    if (node.count == 0) {
      open.push_back(index + 1);
      open.push_back(node.right);
    }
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      const Triangle triangle = mesh.triangle(mesh.order()[i]);
      const int side = orientation(triangle[0], triangle[1], triangle[2], point);
      if (side == 0 && segment_meets_triangle({point, point}, triangle)) return PointPlace::boundary;
      const std::array<glm::dvec2, 3> flat = {projected(triangle[0], 0), projected(triangle[1], 0),
                                              projected(triangle[2], 0)};
      const int around = winding_number(flat, projected(point, 0));
      // Counter-clockwise in (y, z) is seen from larger x: the point lies behind it where it sees it clockwise.
      if (around != 0 && side == -around) winding += around;
    }
  }
  return winding != 0 ? PointPlace::inside : PointPlace::outside;
}

}  // namespace morphcl
