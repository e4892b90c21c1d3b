#include "morphcl/numerics.hpp"

#include <array>
#include <cmath>
#include <cstddef>

#include "host/math/double_double.hpp"
#include "host/math/exact_sign.hpp"
#include "host/math/unit_roundoff.hpp"

namespace morphcl {

namespace {

constexpr double u = unit_roundoff<double>;

// A sum of doubles that do not overlap, smallest first.
template <std::size_t Capacity>
class Expansion {
 public:
  // Shewchuk's GROW-EXPANSION; components of 0 are left out.
  void add(double term) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < count_; ++i) {
      const DoubleDouble sum = two_sum(term, components_[i]);
      if (sum.low != 0) components_[kept++] = sum.low;
      term = sum.high;
    }
    if (term != 0) components_[kept++] = term;
    count_ = kept;
  }
  void add(const DoubleDouble& product) {
    add(product.low);
    add(product.high);
  }
  // x y z without rounding.
  void add_product(double x, double y, double z) {
    const DoubleDouble xy = two_product(x, y);
    add(two_product(xy.low, z));
    add(two_product(xy.high, z));
  }
  int sign() const {
    if (count_ == 0) return 0;
    return components_[count_ - 1] > 0 ? 1 : -1;
  }

 private:
  std::array<double, Capacity> components_{};
  std::size_t count_ = 0;
};

int sign_beyond(double value, double bound) {
  if (value > bound) return 1;
  return value < -bound ? -1 : 0;
}

// What products of two and three coordinates lose by underflow is below 2^-1000, taken up into the bounds of errors.
constexpr double underflow_guard = 0x1p-1000;

// No product of three overflows, and none loses a bit by underflow.
bool suits_expansion(double x) {
  const double size = std::abs(x);
  return size == 0 || (size >= 1e-90 && size <= 1e90);
}

template <int N>
bool suits_expansion(const glm::vec<N, double>& point) {
  for (int i = 0; i < N; ++i)
    if (!suits_expansion(point[i])) return false;
  return true;
}

int exact_orientation(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  if (!suits_expansion(a) || !suits_expansion(b) || !suits_expansion(c))
    return exact_sign([&](auto number) {
      return (number(a.x) - number(c.x)) * (number(b.y) - number(c.y)) -
             (number(a.y) - number(c.y)) * (number(b.x) - number(c.x));
    });
  Expansion<12> sum;
  const auto add_cross = [&sum](const glm::dvec2& p, const glm::dvec2& q) {
    sum.add(two_product(p.x, q.y));
    sum.add(two_product(-p.y, q.x));
  };
  add_cross(a, b);
  add_cross(b, c);
  add_cross(c, a);
  return sum.sign();
}

// det(a b c) - det(b c d) + det(c d a) - det(d a b), the signed volume of the differences from d, expanded.
int exact_orientation(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d) {
  if (!suits_expansion(a) || !suits_expansion(b) || !suits_expansion(c) || !suits_expansion(d))
    return exact_sign([&](auto number) {
      const auto minor = [&](int i, int j) {
        return (number(b[i]) - number(d[i])) * (number(c[j]) - number(d[j])) -
               (number(b[j]) - number(d[j])) * (number(c[i]) - number(d[i]));
      };
      return (number(a.x) - number(d.x)) * minor(1, 2) + (number(a.y) - number(d.y)) * minor(2, 0) +
             (number(a.z) - number(d.z)) * minor(0, 1);
    });
  Expansion<96> sum;
  const auto add_determinant = [&sum](double sign, const glm::dvec3& p, const glm::dvec3& q, const glm::dvec3& r) {
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      sum.add_product(sign * p[i], q[j], r[k]);
      sum.add_product(-sign * p[i], q[k], r[j]);
    }
  };
  add_determinant(1, a, b, c);
  add_determinant(-1, b, c, d);
  add_determinant(1, c, d, a);
  add_determinant(-1, d, a, b);
  return sum.sign();
}

}  // namespace

int orientation(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  const double left = (a.x - c.x) * (b.y - c.y), right = (a.y - c.y) * (b.x - c.x);
  constexpr double error = (3 + 16 * u) * u;  // Shewchuk's bound A
  const int sign = sign_beyond(left - right, error * (std::abs(left) + std::abs(right) + underflow_guard));
  return sign != 0 ? sign : exact_orientation(a, b, c);
}

int orientation(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d) {
  const glm::dvec3 p = a - d, q = b - d, r = c - d;
  double determinant = 0, size = 0;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    const double forward = q[j] * r[k], backward = q[k] * r[j];
    determinant += p[i] * (forward - backward);
    size += std::abs(p[i]) * (std::abs(forward) + std::abs(backward) + underflow_guard) + underflow_guard;
  }
  // d sees a, b, c counter-clockwise where the determinant is negative.
  constexpr double error = (7 + 56 * u) * u;  // Shewchuk's bound A
  const int sign = sign_beyond(determinant, error * size);
  return -(sign != 0 ? sign : exact_orientation(a, b, c, d));
}

}  // namespace morphcl
