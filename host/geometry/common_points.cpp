#include <algorithm>
#include <cstddef>
#include <optional>
#include <tuple>

#include "host/geometry/exact_space.hpp"
#include "host/geometry/triangle_contact.hpp"
#include "morphcl/collision.hpp"

namespace morphcl {

namespace {

using Points = std::vector<glm::dvec3>;

// Adds it once: points that are the same exactly are rounded to the same.
void add_point(Points& points, const glm::dvec3& point) {
  if (std::find(points.begin(), points.end(), point) == points.end()) points.push_back(point);
}

void add_corners_within(Points& points, const Triangle& of, const Triangle& triangle) {
  for (const glm::dvec3& corner : of)
    if (segment_meets_triangle({corner, corner}, triangle)) add_point(points, corner);
}

// Where the edges of `of` pass from one side of the triangle's plane to the other within the triangle.
void add_piercings(Points& points, const Triangle& of, const Triangle& triangle) {
  for (std::size_t i = 0; i < 3; ++i) {
    const glm::dvec3 &from = of[i], &to = of[(i + 1) % 3];
    const int side_of_from = orientation(triangle[0], triangle[1], triangle[2], from);
    const int side_of_to = orientation(triangle[0], triangle[1], triangle[2], to);
    if (side_of_from * side_of_to >= 0 || !segment_meets_triangle({from, to}, triangle)) continue;
    const ExactNumber volume_of_from = exact_volume(triangle[0], triangle[1], triangle[2], from);
    const ExactNumber volume_of_to = exact_volume(triangle[0], triangle[1], triangle[2], to);
    add_point(points, point_between(from, -volume_of_to, to, volume_of_from));
  }
}

// Where edges that lie in one plane cross, off their ends.
void add_edge_crossings(Points& points, const Triangle& a, const Triangle& b) {
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      const glm::dvec3 &p = a[i], &q = a[(i + 1) % 3], &r = b[j], &s = b[(j + 1) % 3];
      auto axis = projection_axis(p, q, r);
      if (!axis) axis = projection_axis(p, q, s);
      if (!axis || orientation(p, q, r, s) != 0) continue;
      const glm::dvec2 p2 = projected(p, *axis), q2 = projected(q, *axis);
      const glm::dvec2 r2 = projected(r, *axis), s2 = projected(s, *axis);
      if (orientation(r2, s2, p2) * orientation(r2, s2, q2) >= 0) continue;
      if (orientation(p2, q2, r2) * orientation(p2, q2, s2) >= 0) continue;
      add_point(points, point_between(p, -exact_area(r2, s2, q2), q, exact_area(r2, s2, p2)));
    }
}

// The convex hull of points in one plane that is seen along the axis, its corners counter-clockwise there.
Points convex_hull(Points points, int axis) {
  const auto flat = [axis](const glm::dvec3& point) { return projected(point, axis); };
  std::sort(points.begin(), points.end(), [&](const glm::dvec3& a, const glm::dvec3& b) {
    const glm::dvec2 p = flat(a), q = flat(b);
    return p.x < q.x || (p.x == q.x && p.y < q.y);
  });
  Points hull;
  const auto extend = [&](const glm::dvec3& point, std::size_t kept) {
    while (hull.size() > kept &&
           orientation(flat(hull[hull.size() - 2]), flat(hull[hull.size() - 1]), flat(point)) <= 0)
      hull.pop_back();
    hull.push_back(point);
  };
  for (const glm::dvec3& point : points) extend(point, 1);
  const std::size_t lower = hull.size();
  for (auto point = points.rbegin() + 1; point != points.rend(); ++point) extend(*point, lower);
  hull.pop_back();
  return hull;
}

}  // namespace

std::vector<glm::dvec3> common_points(const Triangle& a, const Triangle& b) {
  Points points;
  if (contact(a, b) == Contact::apart) return points;
  add_corners_within(points, a, b);
  add_corners_within(points, b, a);
  add_piercings(points, a, b);
  add_piercings(points, b, a);
  add_edge_crossings(points, a, b);
  if (points.size() < 3) return points;
  auto axis = projection_axis(a[0], a[1], a[2]);
  if (!axis) axis = projection_axis(b[0], b[1], b[2]);
  if (axis) return convex_hull(points, *axis);
  const auto [first, last] = std::minmax_element(points.begin(), points.end(), [](const auto& p, const auto& q) {
    return std::tie(p.x, p.y, p.z) < std::tie(q.x, q.y, q.z);
  });
  return {*first, *last};  // all on one line
}

}  // namespace morphcl
