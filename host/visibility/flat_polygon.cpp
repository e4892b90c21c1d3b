#include "morphcl/hidden_surfaces.hpp"

#include <fmt/core.h>

#include <cstdlib>
#include <utility>

#include "host/visibility/wide_integer.hpp"
#include "morphcl/error.hpp"

namespace morphcl {

namespace {

using Vector = glm::vec<3, std::int64_t>;

[[noreturn]] void refuse(const std::string& message) { throw Error(ErrorKind::usage, "", message); }

Vector cross(const glm::ivec3& a, const glm::ivec3& b, const glm::ivec3& c) {
  const Vector u = Vector(b) - Vector(a), v = Vector(c) - Vector(b);
  return {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
}

std::int64_t dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

// The depth at a pixel's centre as a quotient with a positive denominator.
struct Depth {
  std::int64_t numerator, denominator;
};

Depth depth_at(const IntegerPlane& plane, int column, int row) {
  const std::int64_t numerator = plane.d - plane.x * (2 * column + 1) - plane.y * (2 * row + 1);
  return plane.z > 0 ? Depth{numerator, plane.z} : Depth{-numerator, -plane.z};
}

}  // namespace

FlatPolygon make_flat_polygon(std::vector<glm::ivec3> corners) {
  const std::size_t count = corners.size();
  if (count < 3) refuse(fmt::format("a polygon has {} corners; it needs at least 3", count));
  for (const glm::ivec3& corner : corners)
    for (int i = 0; i < 3; ++i)
      if (corner[i] < -max_polygon_coordinate || corner[i] > max_polygon_coordinate)
        refuse(
            fmt::format("a polygon's coordinate is {}; {} is the largest possible", corner[i], max_polygon_coordinate));
  Vector normal(0);
  for (std::size_t i = 0; i < count && normal == Vector(0); ++i)
    normal = cross(corners[i], corners[(i + 1) % count], corners[(i + 2) % count]);
  if (normal == Vector(0)) refuse("a polygon has no area; its corners must not lie in one line");
  const std::int64_t d = dot(normal, Vector(corners[0]));
  for (std::size_t i = 0; i < count; ++i) {
    const glm::ivec3 &a = corners[i], &b = corners[(i + 1) % count], &c = corners[(i + 2) % count];
    if (dot(normal, Vector(a)) != d) refuse(fmt::format("corner {} of a polygon is not in the plane of the others", i));
    // Every other corner is to the left of every edge: this refuses polygons that wind round twice as well.
    for (const glm::ivec3& other : corners)
      if (dot(normal, cross(a, b, other)) < 0) refuse(fmt::format("a polygon is not convex at corner {}", i));
    if (a == b || dot(normal, cross(a, b, c)) < 0) refuse(fmt::format("a polygon is not convex at corner {}", i));
  }
  return {std::move(corners), {normal.x, normal.y, normal.z, d}};
}

bool covers(const FlatPolygon& polygon, int column, int row) {
  if (polygon.plane.z == 0) return false;
  const std::int64_t turn = polygon.plane.z > 0 ? 1 : -1;
  const std::size_t count = polygon.corners.size();
  for (std::size_t i = 0; i < count; ++i) {
    const glm::ivec3 &a = polygon.corners[i], &b = polygon.corners[(i + 1) % count];
    // Along the edge with the inside to the left.
    const std::int64_t dx = turn * (b.x - a.x), dy = turn * (b.y - a.y);
    const std::int64_t side = dx * (2 * row + 1 - a.y) - dy * (2 * column + 1 - a.x);
    const bool owns_edge = dy < 0 || (dy == 0 && dx > 0);
    if (side < 0 || (side == 0 && !owns_edge)) return false;
  }
  return true;
}

int compare_depth(const FlatPolygon& a, const FlatPolygon& b, int column, int row) {
  const Depth p = depth_at(a.plane, column, row), q = depth_at(b.plane, column, row);
  const Int128 left = Int128{p.numerator} * q.denominator, right = Int128{q.numerator} * p.denominator;
  return (left > right) - (left < right);
}

PolygonPicture::PolygonPicture(int picture_width, int picture_height)
    : width(picture_width), height(picture_height), polygon(static_cast<std::size_t>(width) * height, -1) {}

bool is_seen_before(const std::vector<FlatPolygon>& polygons, int challenger, int holder, int column, int row) {
  if (holder < 0) return true;
  const int nearer = compare_depth(polygons[static_cast<std::size_t>(challenger)],
                                   polygons[static_cast<std::size_t>(holder)], column, row);
  return nearer > 0 || (nearer == 0 && challenger < holder);
}

}  // namespace morphcl
