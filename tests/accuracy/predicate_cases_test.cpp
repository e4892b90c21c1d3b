// Catalogue of extreme cases: decisions that are exact or wrong.
#include <boost/multiprecision/cpp_int.hpp>

#include <algorithm>

#include "morphcl/numerics.hpp"
#include "tests/accuracy/demand.hpp"
#include "tests/accuracy/naive_forms.hpp"
#include "tests/support/random.hpp"

namespace morphcl::accuracy {
namespace {

using test_support::Random;

using Rational = boost::multiprecision::cpp_rational;

int sign_of(const Rational& value) { return value > 0 ? 1 : value < 0 ? -1 : 0; }

int exact_orientation(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  return sign_of((Rational(b.x) - Rational(a.x)) * (Rational(c.y) - Rational(a.y)) -
                 (Rational(b.y) - Rational(a.y)) * (Rational(c.x) - Rational(a.x)));
}

int exact_orientation(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d) {
  const auto difference = [](const glm::dvec3& p, const glm::dvec3& q) {
    return std::array<Rational, 3>{Rational(p.x) - Rational(q.x), Rational(p.y) - Rational(q.y),
                                   Rational(p.z) - Rational(q.z)};
  };
  const auto u = difference(b, a), v = difference(c, a), w = difference(d, a);
  return sign_of((u[1] * v[2] - u[2] * v[1]) * w[0] + (u[2] * v[0] - u[0] * v[2]) * w[1] +
                 (u[0] * v[1] - u[1] * v[0]) * w[2]);
}

// 16384 pixels at 256 sub-pixels each: points within two sub-pixels of an edge.
TEST(ExtremeCase, EdgeFunctions) {
  Random random(8);
  Worst stable, products, coefficients;
  const auto add = [&](const glm::ivec2& a, const glm::ivec2& b, const glm::ivec2& p) {
    const int exact = exact_orientation(glm::dvec2(a), glm::dvec2(b), glm::dvec2(p));
    const auto [by_products, by_coefficients] = naive::edge_signs(a, b, p);
    stable.add_exact(orientation(glm::dvec2(a), glm::dvec2(b), glm::dvec2(p)) == exact);
    products.add_exact(by_products == exact);
    coefficients.add_exact(by_coefficients == exact);
  };
  add({0, 0}, {4194303, 4194302}, {4194302, 4194301});
  EXPECT_EQ(orientation(glm::dvec2(0, 0), {4194303, 4194302}, {4194302, 4194301}), -1);
  constexpr int edge = 16384 * 256;
  for (int i = 0; i < 20'000; ++i) {
    const auto any = [&] {
      return glm::ivec2{static_cast<int>(random.integer_in(0, edge)), static_cast<int>(random.integer_in(0, edge))};
    };
    const glm::ivec2 a = any(), b = any();
    const double t = random.in(0, 1);
    const glm::ivec2 near(glm::round(glm::dvec2(a) + t * glm::dvec2(b - a)));
    add(a, b,
        near + glm::ivec2{static_cast<int>(random.integer_in(-2, 2)), static_cast<int>(random.integer_in(-2, 2))});
  }
  expect_demand(stable, products);
  expect_demand(stable, coefficients);
}

// Points next to a line in fp64, where the determinant is far below the rounding of its products.
TEST(ExtremeCase, OrientationNextToALineAndAPlane) {
  Random random(9);
  Worst stable, naive_form;
  for (int i = 0; i < 5000; ++i) {
    const auto any = [&] { return random.vector(1); };
    const glm::dvec3 a = any(), b = any(), c = any();
    const double s = random.in(-2, 2), t = random.in(-2, 2);
    glm::dvec3 d = a + s * (b - a) + t * (c - a);
    if (i % 3 == 0) d.x = std::nextafter(d.x, 9.0);
    const glm::dvec2 p(a), q(b), r = p + s * (q - p);
    stable.add_exact(orientation(a, b, c, d) == exact_orientation(a, b, c, d));
    stable.add_exact(orientation(p, q, r) == exact_orientation(p, q, r));
    const double determinant = (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
    naive_form.add_exact((determinant > 0) - (determinant < 0) == exact_orientation(p, q, r));
  }
  EXPECT_EQ(orientation({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}), 1);
  EXPECT_EQ(orientation({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 7, 0}), 0);
  EXPECT_EQ(orientation({0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {5, 7, 0}), 0) << "three points of one line";
  expect_demand(stable, naive_form);
}

// By rationals: the parity of crossings of a ray to the right, and the boundary by orientation.
PointPlace exact_place(const std::vector<glm::vec2>& polygon, const glm::vec2& point) {
  bool inside = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec2 a = polygon[i], b = polygon[(i + 1) % polygon.size()], p = point;
    const bool in_box = p.x >= std::min(a.x, b.x) && p.x <= std::max(a.x, b.x) && p.y >= std::min(a.y, b.y) &&
                        p.y <= std::max(a.y, b.y);
    if (in_box && exact_orientation(a, b, p) == 0) return PointPlace::boundary;
    if ((a.y > p.y) == (b.y > p.y)) continue;
    const Rational x = Rational(a.x) + (Rational(p.y) - Rational(a.y)) / (Rational(b.y) - Rational(a.y)) *
                                           (Rational(b.x) - Rational(a.x));
    if (x > Rational(p.x)) inside = !inside;
  }
  return inside ? PointPlace::inside : PointPlace::outside;
}

// A star without crossings, and points on its corners, on its edges and within 1e-4 of them.
TEST(ExtremeCase, PointInPolygon) {
  Random random(10);
  Worst stable, naive_form;
  for (int star = 0; star < 40; ++star) {
    std::vector<glm::vec2> polygon;
    const int corners = static_cast<int>(random.integer_in(3, 12));
    for (int i = 0; i < corners; ++i) {
      const double angle = 6.283185307179586 * (i + random.in(0.1, 0.9)) / corners, radius = random.in(0.3, 1);
      polygon.push_back(glm::vec2(radius * std::cos(angle), radius * std::sin(angle)));
    }
    if (star % 2 == 1) std::reverse(polygon.begin(), polygon.end());
    const std::vector<glm::dvec2> exact_polygon(polygon.begin(), polygon.end());
    for (int i = 0; i < 60; ++i) {
      const auto corner = static_cast<std::size_t>(random.integer_in(0, corners - 1));
      const glm::vec2 a = polygon[corner], b = polygon[(corner + 1) % polygon.size()];
      const double t = i % 10 == 0 ? 0 : random.in(0, 1), off = i % 3 == 0 ? 0 : 1e-4;
      const glm::vec2 point(glm::dvec2(a) + t * glm::dvec2(b - a) +
                            glm::dvec2{random.in(-off, off), random.in(-off, off)});
      const PointPlace exact = exact_place(polygon, point);
      stable.add_exact(place_in_polygon(exact_polygon, point) == exact);
      naive_form.add_exact(exact == PointPlace::boundary ||
                           naive::inside_by_angles(polygon, point) == (exact == PointPlace::inside));
    }
  }
  expect_demand(stable, naive_form);
}

TEST(PointInPolygon, WindsTwiceAroundACrossingPolygonsMiddle) {
  const std::vector<glm::dvec2> pentagram = {{0, 10}, {6, -8}, {-9, 3}, {9, 3}, {-6, -8}};
  EXPECT_EQ(std::abs(winding_number(pentagram, {0, 0})), 2);
  EXPECT_EQ(place_in_polygon(pentagram, {0, 0}), PointPlace::inside);
  EXPECT_EQ(place_in_polygon(pentagram, {0, 3}), PointPlace::boundary);
  EXPECT_EQ(place_in_polygon(pentagram, {0, -9}), PointPlace::outside);
  EXPECT_EQ(place_in_polygon({}, {0, 0}), PointPlace::outside);
}

}  // namespace
}  // namespace morphcl::accuracy
