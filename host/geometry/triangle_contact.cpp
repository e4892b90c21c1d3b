#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

#include "host/geometry/exact_space.hpp"
#include "host/geometry/triangle_contact.hpp"
#include "morphcl/collision.hpp"

namespace morphcl {

namespace {

using Triangle2 = std::array<glm::dvec2, 3>;

Triangle2 flattened(const Triangle& triangle, int axis) {
  return {projected(triangle[0], axis), projected(triangle[1], axis), projected(triangle[2], axis)};
}

std::optional<int> axis_of(const Triangle& triangle) { return projection_axis(triangle[0], triangle[1], triangle[2]); }

int side_of_triangle(const Triangle& triangle, const glm::dvec3& point) {
  return orientation(triangle[0], triangle[1], triangle[2], point);
}

std::array<int, 3> sides_of_triangle(const Triangle& triangle, const Triangle& points) {
  return {side_of_triangle(triangle, points[0]), side_of_triangle(triangle, points[1]),
          side_of_triangle(triangle, points[2])};
}

// In the plane; boxes decide between points of one line.
bool segments_meet(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c, const glm::dvec2& d) {
  for (int i = 0; i < 2; ++i)
    if (std::max(a[i], b[i]) < std::min(c[i], d[i]) || std::max(c[i], d[i]) < std::min(a[i], b[i])) return false;
  return orientation(a, b, c) * orientation(a, b, d) <= 0 && orientation(c, d, a) * orientation(c, d, b) <= 0;
}

bool is_in_triangle(const Triangle2& triangle, const glm::dvec2& point) {
  return place_in_polygon(triangle, point) != PointPlace::outside;
}

bool boxes_meet(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d) {
  for (int i = 0; i < 3; ++i)
    if (std::max(a[i], b[i]) < std::min(c[i], d[i]) || std::max(c[i], d[i]) < std::min(a[i], b[i])) return false;
  return true;
}

bool segments_meet(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d) {
  if (!boxes_meet(a, b, c, d) || orientation(a, b, c, d) != 0) return false;
  for (const auto& [p, q, r] : {Triangle{a, b, c}, Triangle{a, b, d}, Triangle{c, d, a}, Triangle{c, d, b}})
    if (const auto axis = projection_axis(p, q, r))
      return segments_meet(projected(a, *axis), projected(b, *axis), projected(c, *axis), projected(d, *axis));
  return true;  // all on one line, where boxes meet
}

// Both in one plane, with area: the sides of all edges of both, turned counter-clockwise.
Contact coplanar_contact(Triangle2 a, Triangle2 b) {
  if (orientation(a[0], a[1], a[2]) < 0) std::swap(a[1], a[2]);
  if (orientation(b[0], b[1], b[2]) < 0) std::swap(b[1], b[2]);
  Contact result = Contact::crossing;
  const auto separate = [&result](const Triangle2& of, const Triangle2& points) {
    for (std::size_t i = 0; i < 3; ++i) {
      int innermost = -1;
      for (const glm::dvec2& point : points)
        innermost = std::max(innermost, orientation(of[i], of[(i + 1) % 3], point));
      if (innermost <= 0) result = std::min(result, innermost < 0 ? Contact::apart : Contact::touching);
    }
  };
  separate(a, b);
  separate(b, a);
  return result;
}

bool is_straddled(const std::array<int, 3>& sides) {
  const auto [low, high] = std::minmax_element(sides.begin(), sides.end());
  return *low < 0 && *high > 0;
}

// The corner that has a side of the plane for itself.
std::size_t lone_corner(const std::array<int, 3>& sides) {
  for (std::size_t i = 0; i < 3; ++i) {
    const int next = sides[(i + 1) % 3], last = sides[(i + 2) % 3];
    if (sides[i] != 0 && next * sides[i] <= 0 && last * sides[i] <= 0 && (next != 0 || last != 0)) return i;
  }
  return 0;
}

// Each has corners on both sides of the other's plane: the overlap of the intervals on the line of both planes. The
// lone corners come first, on the positive sides: where one is not, the other triangle is turned over.
Contact interval_contact(const Triangle& a, const std::array<int, 3>& sides_of_a, const Triangle& b,
                         const std::array<int, 3>& sides_of_b) {
  const std::size_t i = lone_corner(sides_of_a), j = lone_corner(sides_of_b);
  Triangle p = {a[i], a[(i + 1) % 3], a[(i + 2) % 3]}, q = {b[j], b[(j + 1) % 3], b[(j + 2) % 3]};
  if (sides_of_a[i] < 0) std::swap(q[1], q[2]);
  if (sides_of_b[j] < 0) std::swap(p[1], p[2]);
  const int first = orientation(p[0], p[1], q[0], q[1]), second = orientation(p[0], p[2], q[2], q[0]);
  if (first > 0 || second > 0) return Contact::apart;
  return first == 0 || second == 0 ? Contact::touching : Contact::crossing;
}

// A corner or an edge of `a` lies in the plane of `b`, and the rest on one side of it.
Contact contact_in_plane(const Triangle& a, const std::array<int, 3>& sides, const Triangle& b) {
  Triangle in_plane = a;
  std::size_t count = 0;
  for (std::size_t i = 0; i < 3; ++i)
    if (sides[i] == 0) in_plane[count++] = a[i];
  if (count == 0) return Contact::apart;
  return segment_meets_triangle({in_plane[0], in_plane[count - 1]}, b) ? Contact::touching : Contact::apart;
}

// The corners of one or both are on a line.
Contact thin_contact(const Triangle& a, const Triangle& b) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (segment_meets_triangle({a[i], a[(i + 1) % 3]}, b)) return Contact::touching;
    if (segment_meets_triangle({b[i], b[(i + 1) % 3]}, a)) return Contact::touching;
  }
  return Contact::apart;
}

}  // namespace

bool segment_meets_triangle(const Segment3& segment, const Triangle& triangle) {
  const int from = side_of_triangle(triangle, segment.from), to = side_of_triangle(triangle, segment.to);
  if (from * to > 0) return false;
  if (from != 0 || to != 0) {
    // Only a triangle with area has sides.
    if (from != 0 && to != 0) {
      int low = 0, high = 0;
      for (std::size_t i = 0; i < 3; ++i) {
        const int side = orientation(segment.from, segment.to, triangle[i], triangle[(i + 1) % 3]);
        low = std::min(low, side);
        high = std::max(high, side);
      }
      return low * high == 0;
    }
    const int axis = *axis_of(triangle);
    return is_in_triangle(flattened(triangle, axis), projected(from == 0 ? segment.from : segment.to, axis));
  }
  const auto axis = axis_of(triangle);
  if (!axis) {
    for (std::size_t i = 0; i < 3; ++i)
      if (segments_meet(segment.from, segment.to, triangle[i], triangle[(i + 1) % 3])) return true;
    return false;
  }
  const Triangle2 flat = flattened(triangle, *axis);
  const glm::dvec2 a = projected(segment.from, *axis), b = projected(segment.to, *axis);
  if (is_in_triangle(flat, a)) return true;
  for (std::size_t i = 0; i < 3; ++i)
    if (segments_meet(a, b, flat[i], flat[(i + 1) % 3])) return true;
  return false;
}

Contact contact(const Triangle& a, const Triangle& b) {
  const std::array<int, 3> sides_of_a = sides_of_triangle(b, a);
  if (sides_of_a[0] * sides_of_a[1] > 0 && sides_of_a[0] * sides_of_a[2] > 0) return Contact::apart;
  const std::array<int, 3> sides_of_b = sides_of_triangle(a, b);
  if (sides_of_b[0] * sides_of_b[1] > 0 && sides_of_b[0] * sides_of_b[2] > 0) return Contact::apart;
  const std::array<int, 3> none{};
  if (sides_of_a == none || sides_of_b == none) {
    const auto axis = axis_of(a);
    if (!axis || !axis_of(b)) return thin_contact(a, b);
    return coplanar_contact(flattened(a, *axis), flattened(b, *axis));
  }
  if (is_straddled(sides_of_a) && is_straddled(sides_of_b)) return interval_contact(a, sides_of_a, b, sides_of_b);
  return is_straddled(sides_of_a) ? contact_in_plane(b, sides_of_b, a) : contact_in_plane(a, sides_of_a, b);
}

}  // namespace morphcl
