#include <cmath>
#include <utility>

#include "host/math/exact_sign.hpp"
#include "morphcl/error.hpp"
#include "morphcl/geometry.hpp"

namespace morphcl {

namespace {

void require_radius(const Sphere& sphere) {
  if (!(sphere.radius >= 0 && std::isfinite(sphere.radius)))
    throw Error(ErrorKind::usage, "", "the radius of a sphere is negative or not finite; give 0 or more");
}

// a . b of vectors of numbers, and a x b.
template <class Vector>
auto dot_product(const Vector& a, const Vector& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class Number>
struct NumberVector {
  Number x, y, z;
};

// a - b.
template <class MakeNumber>
auto difference_of(MakeNumber number, const glm::dvec3& a, const glm::dvec3& b) {
  return NumberVector<decltype(number(0.0))>{number(a.x) - number(b.x), number(a.y) - number(b.y),
                                             number(a.z) - number(b.z)};
}

template <class Number>
Number squared_length_of_cross(const NumberVector<Number>& a, const NumberVector<Number>& b) {
  const NumberVector<Number> cross{a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
  return dot_product(cross, cross);
}

// The sign of |point - center|^2 - (radius + more)^2.
int side_of_sphere(const glm::dvec3& center, const glm::dvec3& point, double radius, double more) {
  return exact_sign([&](auto number) {
    const auto apart = difference_of(number, point, center);
    const auto sum = number(radius) + number(more);
    return dot_product(apart, apart) - sum * sum;
  });
}

}  // namespace

Contact contact(const Sphere& a, const Sphere& b) {
  require_radius(a);
  require_radius(b);
  const int side = side_of_sphere(a.center, b.center, a.radius, b.radius);
  return side > 0 ? Contact::apart : side == 0 ? Contact::touching : Contact::crossing;
}

PointPlace place_in_sphere(const Sphere& sphere, const glm::dvec3& point) {
  require_radius(sphere);
  const int side = side_of_sphere(sphere.center, point, sphere.radius, 0);
  return side > 0 ? PointPlace::outside : side == 0 ? PointPlace::boundary : PointPlace::inside;
}

LineSphere intersect_line(const Segment3& line, const Sphere& sphere) {
  require_radius(sphere);
  if (line.from == line.to)
    throw Error(ErrorKind::usage, "", "both ends of a line are the same point; give two different ones");
  // |direction x (center - from)|^2 against radius^2 |direction|^2.
  const auto spare = [&](auto number) {
    const auto direction = difference_of(number, line.to, line.from);
    const auto center = difference_of(number, sphere.center, line.from);
    const auto radius = number(sphere.radius);
    return radius * radius * dot_product(direction, direction) - squared_length_of_cross(direction, center);
  };
  LineSphere result;
  const int sign = exact_sign(spare);
  if (sign < 0) return result;
  result.contact = sign == 0 ? Contact::touching : Contact::crossing;
  // t^2 |direction|^2 - 2 t direction . center + |center|^2 - radius^2 = 0
  const auto exact = [](double value) { return ExactNumber(value); };
  const auto direction = difference_of(exact, line.to, line.from),
             center = difference_of(exact, sphere.center, line.from);
  const ExactNumber squared = dot_product(direction, direction), radius(sphere.radius);
  const double middle = quotient(dot_product(direction, center), squared);
  const double half_chord = square_root_of_quotient(spare(exact), squared * squared);
  const double product = quotient(dot_product(center, center) - radius * radius, squared);
  // The root farther from 0 adds up; the other one follows from the product of both.
  const double farther = middle < 0 ? middle - half_chord : middle + half_chord;
  const double nearer = farther == 0 ? 0 : product / farther;
  result.enter = middle < 0 ? farther : nearer;
  result.leave = middle < 0 ? nearer : farther;
  if (result.enter > result.leave) std::swap(result.enter, result.leave);  // by an ulp
  if (sign == 0) result.enter = result.leave = middle;
  return result;
}

}  // namespace morphcl
