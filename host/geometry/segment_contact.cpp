#include <array>
#include <cstddef>

#include "host/geometry/exact_space.hpp"
#include "host/math/exact_sign.hpp"
#include "morphcl/error.hpp"
#include "morphcl/geometry.hpp"

namespace morphcl {

namespace {

// The distances of a segment's ends from a face of the box, positive on the inner side.
struct BoundaryValues {
  std::array<double, 2> from{}, to{};  // value = first - second, at either end
};

// (f - s) of a boundary at one end, as a number.
template <class MakeNumber>
auto value_of(MakeNumber number, const std::array<double, 2>& terms) {
  return number(terms[0]) - number(terms[1]);
}

int sign_of_value(const std::array<double, 2>& terms) { return terms[0] > terms[1] ? 1 : terms[0] < terms[1] ? -1 : 0; }

// The sign of p(a) q(b) - p(b) q(a), for boundaries p and q and the ends a and b.
int compare_boundaries(const BoundaryValues& p, const BoundaryValues& q) {
  return exact_sign([&](auto number) {
    return value_of(number, p.from) * value_of(number, q.to) - value_of(number, p.to) * value_of(number, q.from);
  });
}

}  // namespace

int side_of_plane(const Plane& plane, const glm::dvec3& point) {
  if (plane.normal == glm::dvec3(0.0))
    throw Error(ErrorKind::usage, "", "the normal of a plane is 0; give a direction");
  return exact_sign([&](auto number) {
    return number(plane.normal.x) * number(point.x) + number(plane.normal.y) * number(point.y) +
           number(plane.normal.z) * number(point.z) - number(plane.offset);
  });
}

Intersection3 intersect(const Segment3& segment, const Plane& plane) {
  const int from = side_of_plane(plane, segment.from), to = side_of_plane(plane, segment.to);
  if (from * to > 0) return {};
  if (from == 0 || to == 0)
    return {Contact::touching, from == 0 ? segment.from : segment.to, to == 0 ? segment.to : segment.from};
  const auto distance = [&plane](const glm::dvec3& point) {
    ExactNumber sum = -ExactNumber(plane.offset);
    for (int i = 0; i < 3; ++i) sum = sum + ExactNumber(plane.normal[i]) * ExactNumber(point[i]);
    return sum;
  };
  const glm::dvec3 at = point_between(segment.from, -distance(segment.to), segment.to, distance(segment.from));
  return {Contact::crossing, at, at};
}

// The segment enters each of six half-spaces, leaves it, or stays on one side: it meets all where the last entry is not
// behind the first exit (Liang and Barsky 1984), and their interior where it is before it.
Intersection3 intersect(const Segment3& segment, const Box& box) {
  const auto exact = [](double value) { return ExactNumber(value); };
  for (int i = 0; i < 3; ++i) value_of(exact, {segment.from[i], segment.to[i]});  // refuses what is not finite
  if (box.empty()) return {};
  std::array<BoundaryValues, 6> boundaries;
  bool inside = segment.from != segment.to;
  const BoundaryValues *last_entry = nullptr, *first_exit = nullptr;
  for (std::size_t i = 0; i < 6; ++i) {
    const int axis = static_cast<int>(i / 2);
    BoundaryValues& values = boundaries[i];
    const double lower = box.lower[axis], upper = box.upper[axis];
    values = i % 2 == 0 ? BoundaryValues{{segment.from[axis], lower}, {segment.to[axis], lower}}
                        : BoundaryValues{{upper, segment.from[axis]}, {upper, segment.to[axis]}};
    const int from = sign_of_value(values.from), to = sign_of_value(values.to);
    if (from < 0 && to < 0) return {};
    if (from <= 0 && to <= 0) inside = false;
    if ((from < 0 || to < 0) && (from == 0 || to == 0)) inside = false;
    // p(a) q(b) > p(b) q(a): of two entries, and of two exits, p is passed first; of an entry p and an exit q, q is.
    if (from < 0 && (last_entry == nullptr || compare_boundaries(values, *last_entry) < 0)) last_entry = &values;
    if (to < 0 && (first_exit == nullptr || compare_boundaries(values, *first_exit) > 0)) first_exit = &values;
  }
  if (last_entry != nullptr && first_exit != nullptr) {
    const int order = compare_boundaries(*last_entry, *first_exit);
    if (order > 0) return {};
    if (order == 0) inside = false;
  }
  for (int i = 0; i < 3; ++i)
    if (box.lower[i] == box.upper[i]) inside = false;
  const auto at = [&](const BoundaryValues& values) {
    return point_between(segment.from, value_of(exact, values.to), segment.to, -value_of(exact, values.from));
  };
  return {inside ? Contact::crossing : Contact::touching, last_entry != nullptr ? at(*last_entry) : segment.from,
          first_exit != nullptr ? at(*first_exit) : segment.to};
}

}  // namespace morphcl
