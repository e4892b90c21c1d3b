#include <algorithm>

#include "host/math/finite.hpp"
#include "morphcl/error.hpp"
#include "morphcl/geometry.hpp"

namespace morphcl {

namespace {

// Of the intervals [a, b] and [c, d] on one axis.
Contact interval_contact(double a, double b, double c, double d) {
  if (b < c || d < a) return Contact::apart;
  return b == c || d == a ? Contact::touching : Contact::crossing;
}

struct Box2 {
  glm::dvec2 lower, upper;
};

// Of at least one corner.
Box2 box2_of(std::span<const glm::dvec2> corners) {
  Box2 box{corners[0], corners[0]};
  for (const glm::dvec2& corner : corners) {
    if (!is_finite(corner)) throw Error(ErrorKind::usage, "", "a coordinate is not finite; give numbers");
    box = {glm::min(box.lower, corner), glm::max(box.upper, corner)};
  }
  return box;
}

}  // namespace

Box box_of(std::span<const glm::dvec3> points) {
  Box box;
  for (const glm::dvec3& point : points) {
    if (!is_finite(point)) throw Error(ErrorKind::usage, "", "a coordinate is not finite; give numbers");
    box.include(point);
  }
  return box;
}

Contact contact(const Box& a, const Box& b) {
  if (a.empty() || b.empty()) return Contact::apart;
  Contact weakest = Contact::crossing;
  for (int i = 0; i < 3; ++i)
    weakest = std::min(weakest, interval_contact(a.lower[i], a.upper[i], b.lower[i], b.upper[i]));
  return weakest;
}

PointPlace place_in_box(const Box& box, const glm::dvec3& point) {
  if (box.empty() || !box.contains(point)) return PointPlace::outside;
  for (int i = 0; i < 3; ++i)
    if (point[i] == box.lower[i] || point[i] == box.upper[i]) return PointPlace::boundary;
  return PointPlace::inside;
}

Contact min_max_test(std::span<const glm::dvec2> a, std::span<const glm::dvec2> b) {
  if (a.empty() || b.empty()) return Contact::apart;
  const Box2 p = box2_of(a), q = box2_of(b);
  return std::min(interval_contact(p.lower.x, p.upper.x, q.lower.x, q.upper.x),
                  interval_contact(p.lower.y, p.upper.y, q.lower.y, q.upper.y));
}

}  // namespace morphcl
