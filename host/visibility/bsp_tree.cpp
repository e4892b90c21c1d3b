#include "host/visibility/bsp_tree.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "host/visibility/wide_integer.hpp"
#include "morphcl/error.hpp"

namespace morphcl {

namespace {

// (x, y, z) / w. Of three planes' intersection: below 2^81, so side_of() stays below 2^117.
struct Point {
  Int128 x, y, z, w;
};

int sign(Int128 value) { return (value > 0) - (value < 0); }

// w = 0 is a direction: the side that it leads to.
int side_of(const IntegerPlane& plane, const Point& p) {
  return sign(plane.x * p.x + plane.y * p.y + plane.z * p.z - plane.d * p.w) * (p.w < 0 ? -1 : 1);
}

Int128 determinant(const std::array<Int128, 3>& a, const std::array<Int128, 3>& b, const std::array<Int128, 3>& c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
}

// By Cramer's rule.
Point intersection(const IntegerPlane& a, const IntegerPlane& b, const IntegerPlane& c) {
  using Column = std::array<Int128, 3>;
  const Column x{a.x, b.x, c.x}, y{a.y, b.y, c.y}, z{a.z, b.z, c.z}, d{a.d, b.d, c.d};
  return {determinant(d, y, z), determinant(x, d, z), determinant(x, y, d), determinant(x, y, z)};
}

// The plane through an edge, parallel to the axis that the polygon's normal is most along, so that the two planes meet.
IntegerPlane plane_through_edge(const glm::ivec3& a, const glm::ivec3& b, const IntegerPlane& polygon) {
  const std::int64_t size[] = {std::abs(polygon.x), std::abs(polygon.y), std::abs(polygon.z)};
  const int axis = static_cast<int>(std::max_element(size, size + 3) - size), u = (axis + 1) % 3, v = (axis + 2) % 3;
  glm::vec<3, std::int64_t> normal(0);
  normal[u] = b[v] - a[v];
  normal[v] = a[u] - b[u];
  return {normal.x, normal.y, normal.z, normal[u] * a[u] + normal[v] * a[v]};
}

// A part with its outline: corner i, and the plane that holds the edge from it to the next.
struct Outline {
  PolygonPart part;
  std::vector<Point> corners;
  std::vector<IntegerPlane> edges;

  void add(const Point& corner, const IntegerPlane& edge) {
    corners.push_back(corner);
    edges.push_back(edge);
  }
};

struct Split {
  bool in_front = false, behind = false;
  Outline front, back;  // where both
};

Split split(const Outline& outline, const IntegerPlane& plane, const IntegerPlane& own_plane) {
  std::vector<int> sides;
  Split result;
  for (const Point& corner : outline.corners) {
    sides.push_back(side_of(plane, corner));
    result.in_front |= sides.back() > 0;
    result.behind |= sides.back() < 0;
  }
  if (!result.in_front || !result.behind) return result;
  result.front.part = result.back.part = outline.part;
  result.front.part.sides.push_back({plane, true});
  result.back.part.sides.push_back({plane, false});
  const std::size_t count = sides.size();
  for (std::size_t i = 0; i < count; ++i) {
    const int here = sides[i], next = sides[(i + 1) % count];
    const Point& corner = outline.corners[i];
    const IntegerPlane& edge = outline.edges[i];
    // A corner on the plane is in both; the side that does not go on with its edge goes on along the plane.
    if (here >= 0) result.front.add(corner, here > 0 || next >= 0 ? edge : plane);
    if (here <= 0) result.back.add(corner, here < 0 || next <= 0 ? edge : plane);
    if (here * next < 0) {
      const Point cut = intersection(own_plane, edge, plane);
      result.front.add(cut, here > 0 ? plane : edge);
      result.back.add(cut, here > 0 ? edge : plane);
    }
  }
  return result;
}

}  // namespace

struct BspTree::Node {
  IntegerPlane plane;
  std::vector<PolygonPart> parts;  // in the plane
  std::unique_ptr<Node> front, back;

  static std::unique_ptr<Node> make(const std::vector<FlatPolygon>& polygons, std::vector<Outline> outlines) {
    if (outlines.empty()) return nullptr;
    auto node = std::make_unique<Node>();
    node->plane = polygons[static_cast<std::size_t>(outlines.front().part.polygon)].plane;
    std::vector<Outline> before, behind;
    for (Outline& outline : outlines) {
      Split halves = split(outline, node->plane, polygons[static_cast<std::size_t>(outline.part.polygon)].plane);
      if (halves.in_front && halves.behind) {
        before.push_back(std::move(halves.front));
        behind.push_back(std::move(halves.back));
      } else if (halves.in_front) {
        before.push_back(std::move(outline));
      } else if (halves.behind) {
        behind.push_back(std::move(outline));
      } else {
        node->parts.push_back(std::move(outline.part));
      }
    }
    std::sort(node->parts.begin(), node->parts.end(),
              [](const PolygonPart& a, const PolygonPart& b) { return a.polygon > b.polygon; });
    outlines.clear();
    node->front = make(polygons, std::move(before));
    node->back = make(polygons, std::move(behind));
    return node;
  }

  void walk(const Point& viewpoint, std::vector<PolygonPart>& order) const {
    const bool seen_from_front = side_of(plane, viewpoint) >= 0;
    const Node *far = seen_from_front ? back.get() : front.get(), *near = seen_from_front ? front.get() : back.get();
    if (far != nullptr) far->walk(viewpoint, order);
    order.insert(order.end(), parts.begin(), parts.end());
    if (near != nullptr) near->walk(viewpoint, order);
  }
};

BspTree::BspTree(const std::vector<FlatPolygon>& polygons) {
  constexpr std::size_t max_polygons = 4096;
  if (polygons.size() > max_polygons)
    throw Error(ErrorKind::usage, "",
                fmt::format("{} polygons; a tree holds {} at most", polygons.size(), max_polygons));
  std::vector<Outline> outlines;
  for (std::size_t i = 0; i < polygons.size(); ++i) {
    const std::vector<glm::ivec3>& corners = polygons[i].corners;
    Outline outline;
    outline.part.polygon = static_cast<int>(i);
    for (std::size_t k = 0; k < corners.size(); ++k)
      outline.add({corners[k].x, corners[k].y, corners[k].z, 1},
                  plane_through_edge(corners[k], corners[(k + 1) % corners.size()], polygons[i].plane));
    outlines.push_back(std::move(outline));
  }
  root_ = Node::make(polygons, std::move(outlines));
}

BspTree::~BspTree() = default;
BspTree::BspTree(BspTree&&) noexcept = default;

std::vector<PolygonPart> BspTree::back_to_front(const std::array<int, 4>& viewpoint) const {
  std::vector<PolygonPart> order;
  const Point eye{viewpoint[0], viewpoint[1], viewpoint[2], viewpoint[3]};
  if (root_) root_->walk(eye, order);
  return order;
}

}  // namespace morphcl
