// Collision: triangles against triangles, segments and points against meshes, and meshes against one another, exactly.
//
// As in geometry.hpp: decisions are exact for the numbers given, computed points have the doubles nearest to the exact
// coordinates. Error(usage) for a coordinate that is not finite.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "morphcl/geometry.hpp"
#include "morphcl/mesh.hpp"

#pragma GCC visibility push(default)
namespace morphcl {

// ---- triangles ------------------------------------------------------------------------------------------------------

using Triangle = std::array<glm::dvec3, 3>;

// crossing: a point is within both, off their edges; they run through each other or overlap in one plane. A triangle
// whose corners are on one line is the segment or point that they span, which touches at most.
//
// Method: Guigue and Devillers (2003), by orientations alone; in one plane by the sides of all edges.
Contact contact(const Triangle& a, const Triangle& b);

// Where they meet: one point, the two ends of a segment, or the corners of a convex polygon of up to six.
// Of triangles that are apart: none.
std::vector<glm::dvec3> common_points(const Triangle& a, const Triangle& b);

// ---- meshes ---------------------------------------------------------------------------------------------------------

// The triangles of a mesh in a tree of boxes: built once, asked often. For any number of threads.
class MeshTree {
 public:
  // Children of a node are the next one and `right`; a leaf (count > 0) has the triangles order()[first ...].
  struct Node {
    Box box;
    std::uint32_t first = 0, count = 0, right = 0;
  };

  // Error(usage) for an index out of range or more than 2^31 triangles. A mesh of no triangles meets nothing.
  MeshTree(std::vector<glm::dvec3> positions, std::vector<glm::uvec3> triangles);
  explicit MeshTree(const Mesh& mesh);  // its base shape

  std::size_t size() const { return triangles_.size(); }
  Triangle triangle(std::size_t i) const;
  const std::vector<Node>& nodes() const { return nodes_; }  // the root first; none for a mesh of no triangles
  const std::vector<std::uint32_t>& order() const { return order_; }

  // Whether every directed edge has one against it, corners at one position being one: then there is an inside.
  bool closed() const { return closed_; }
  // A corner of each connected part.
  const std::vector<glm::dvec3>& part_corners() const { return part_corners_; }

 private:
  std::uint32_t build(std::uint32_t first, std::uint32_t count, const std::vector<Box>& boxes);
  void find_parts();

  std::vector<glm::dvec3> positions_;
  std::vector<glm::uvec3> triangles_;
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> order_;
  std::vector<glm::dvec3> part_corners_;
  bool closed_ = true;
};

struct MeshHit {
  std::uint32_t triangle = 0;
  Intersection3 at;  // crossing: through the triangle, off its edges, from one side to the other
};

// Every triangle that the segment meets, by the distance of at.from from segment.from, then by index.
std::vector<MeshHit> intersect(const Segment3& segment, const MeshTree& mesh);

// boundary: on a triangle. inside: where the mesh winds around the point other than 0 times, whichever way its
// triangles face. Of a mesh of no triangles: outside. Error(usage) for a mesh that is not closed, which has no inside.
PointPlace place_in_mesh(const MeshTree& mesh, const glm::dvec3& point);

// ---- collision ------------------------------------------------------------------------------------------------------

struct TriangleContact {
  std::uint32_t a = 0, b = 0;  // indices of triangles
  Contact contact = Contact::apart;
  std::vector<glm::dvec3> points;  // as common_points()
};

struct Collision {
  Contact contact = Contact::apart;     // of the surfaces: crossing where any two triangles cross
  bool a_in_b = false, b_in_a = false;  // surfaces apart, and a part of one is inside the other, a closed mesh
  std::size_t count = 0;                // of pairs of triangles that meet
  std::vector<TriangleContact> pairs;   // the first of them, by a, then b

  bool collides() const { return contact != Contact::apart || a_in_b || b_in_a; }
};

constexpr std::size_t default_max_pairs = 10'000;

// Neighbouring triangles of one surface count one by one: an edge that lies on the other mesh touches twice.
Collision collide(const MeshTree& a, const MeshTree& b, std::size_t max_pairs = default_max_pairs);

}  // namespace morphcl
#pragma GCC visibility pop
