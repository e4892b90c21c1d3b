#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

#include "host/math/exact_number.hpp"
#include "host/math/unit_roundoff.hpp"
#include "morphcl/error.hpp"
#include "morphcl/geometry.hpp"

namespace morphcl {

namespace {

constexpr double max_enclosed_coordinate = 1e300;
constexpr int max_rounds = 200;

// Up to 4 points that a sphere passes through, and its centre as their mean by weights of sum 1.
struct Support {
  std::array<glm::dvec3, 5> points{};
  std::size_t count = 0;
};

struct Circumcenter {
  glm::dvec3 center{0.0};
  std::array<double, 4> weights{};
};

// |vector| without overflow and underflow of squares, within 6u.
double distance_norm(const glm::dvec3& vector) {
  const double size = std::max({std::abs(vector.x), std::abs(vector.y), std::abs(vector.z)});
  if (size == 0) return 0;
  const int exponent = std::ilogb(size);
  double sum = 0;
  for (int i = 0; i < 3; ++i) {
    const double part = std::ldexp(vector[i], -exponent);
    sum += part * part;
  }
  return std::ldexp(std::sqrt(sum), exponent);
}

// At least as large as every distance to the centre. The factor covers the difference (u), the norm (6u) and itself;
// the last term a result that is rounded among subnormals.
double radius_around(const glm::dvec3& center, std::span<const glm::dvec3> points) {
  double radius = 0;
  for (const glm::dvec3& point : points) radius = std::max(radius, distance_norm(point - center));
  return radius == 0 ? 0 : radius * (1 + 16 * unit_roundoff<double>)+0x1p-1074;
}

// The point of equal distance from all in their span; none where they span too little for the arithmetic.
std::optional<Circumcenter> circumcenter(std::span<const glm::dvec3> points) {
  Circumcenter result;
  const glm::dvec3 origin = points[0];
  if (points.size() == 1) return Circumcenter{origin, {1}};
  double size = 0;
  for (const glm::dvec3& point : points) size = std::max(size, distance_norm(point - origin));
  if (size == 0) return std::nullopt;
  const int exponent = std::ilogb(size);
  std::array<glm::dvec3, 3> edge{};
  for (std::size_t i = 1; i < points.size(); ++i)
    for (int k = 0; k < 3; ++k) edge[i - 1][k] = std::ldexp(points[i][k] - origin[k], -exponent);
  const auto& [a, b, c] = edge;
  glm::dvec3 center{0.0};  // from the origin, scaled
  std::array<double, 3> weight{};
  const double aa = glm::dot(a, a), bb = glm::dot(b, b), cc = glm::dot(c, c);
  const glm::dvec3 ab = glm::cross(a, b);
  if (points.size() == 2) {
    if (aa == 0) return std::nullopt;
    center = 0.5 * a;
    weight = {0.5, 0, 0};
  } else if (points.size() == 3) {
    const double squared = glm::dot(ab, ab);
    if (!(squared > 0)) return std::nullopt;
    center = glm::cross(aa * b - bb * a, ab) / (2 * squared);
    const glm::dvec3 across_b = glm::cross(b, ab), across_a = glm::cross(ab, a);
    weight = {glm::dot(center, across_b) / glm::dot(a, across_b), glm::dot(center, across_a) / glm::dot(b, across_a),
              0};
  } else {
    const glm::dvec3 bc = glm::cross(b, c), ca = glm::cross(c, a);
    const double determinant = glm::dot(a, bc);
    if (determinant == 0) return std::nullopt;
    center = (aa * bc + bb * ca + cc * ab) / (2 * determinant);
    weight = {glm::dot(center, bc) / determinant, glm::dot(center, ca) / determinant,
              glm::dot(center, ab) / determinant};
  }
  result.weights = {1 - weight[0] - weight[1] - weight[2], weight[0], weight[1], weight[2]};
  for (int k = 0; k < 3; ++k) result.center[k] = origin[k] + std::ldexp(center[k], exponent);
  for (int k = 0; k < 3; ++k)
    if (!(std::abs(result.center[k]) <= max_enclosed_coordinate)) return std::nullopt;
  return result;
}

// sqrt(sum l |p - c|^2), c = sum l p, of the weights that are not negative: what no enclosing sphere's radius is below.
double spread(const Support& support, const Circumcenter& at) {
  double sum = 0;
  glm::dvec3 mean(0.0);  // from the centre
  for (std::size_t i = 0; i < support.count; ++i) {
    const double weight = std::max(at.weights[i], 0.0);
    sum += weight;
    mean += weight * (support.points[i] - at.center);
  }
  if (!(sum > 0)) return 0;
  mean /= sum;
  double size = 0, squares = 0;
  for (std::size_t i = 0; i < support.count; ++i)
    size = std::max(size, distance_norm(support.points[i] - at.center - mean));
  if (size == 0) return 0;
  for (std::size_t i = 0; i < support.count; ++i) {
    const double part = distance_norm(support.points[i] - at.center - mean) / size;
    squares += std::max(at.weights[i], 0.0) / sum * part * part;
  }
  return size * std::sqrt(squares);
}

// The subset of the support whose circumcenter's sphere around all is proved to be the smallest, or nearest to it.
struct SmallSphere {
  Support support;
  Circumcenter at;
  double radius = std::numeric_limits<double>::infinity();
};

SmallSphere smallest_of(const Support& all) {
  SmallSphere best;
  double min_gap = std::numeric_limits<double>::infinity();
  for (unsigned subset = 1; subset < 1u << all.count; ++subset) {
    Support support;
    for (std::size_t i = 0; i < all.count; ++i)
      if ((subset >> i & 1u) != 0) support.points[support.count++] = all.points[i];
    if (support.count > 4) continue;
    const auto at = circumcenter({support.points.data(), support.count});
    if (!at) continue;
    const double radius = radius_around(at->center, {all.points.data(), all.count});
    const double gap = radius - spread(support, *at);
    if (!(gap < min_gap)) continue;
    best = {support, *at, radius};
    min_gap = gap;
  }
  return best;
}

// sqrt(sum l |p - c|^2) of the weights that are not negative, rounded downwards: (s sum l |p|^2 - |sum l p|^2) / s^2
// without rounding but of the quotient, s = sum l.
double proved_min_radius(const SmallSphere& sphere) {
  ExactNumber sum, squares;
  std::array<ExactNumber, 3> mean;
  for (std::size_t i = 0; i < sphere.support.count; ++i) {
    if (!(sphere.at.weights[i] > 0)) continue;
    const ExactNumber weight(sphere.at.weights[i]);
    sum = sum + weight;
    for (int k = 0; k < 3; ++k) {
      const ExactNumber moment = weight * ExactNumber(sphere.support.points[i][k]);
      mean[static_cast<std::size_t>(k)] = mean[static_cast<std::size_t>(k)] + moment;
      squares = squares + moment * ExactNumber(sphere.support.points[i][k]);
    }
  }
  if (sum.sign() == 0) return 0;
  ExactNumber spread = sum * squares;
  for (const ExactNumber& part : mean) spread = spread - part * part;
  return square_root_of_quotient(spread, sum * sum) * (1 - 4 * unit_roundoff<double>);
}

}  // namespace

EnclosingSphere enclosing_sphere(std::span<const glm::dvec3> points) {
  if (points.empty()) throw Error(ErrorKind::usage, "", "a sphere around no points was asked for; give at least one");
  for (const glm::dvec3& point : points)
    for (int k = 0; k < 3; ++k)
      if (!(std::abs(point[k]) <= max_enclosed_coordinate))
        throw Error(ErrorKind::usage, "", "a coordinate is beyond 1e300 or not finite; scale the points");
  SmallSphere current;
  current.support = {{points[0]}, 1};
  current.at = {points[0], {1}};
  current.radius = 0;
  EnclosingSphere best{{points[0], std::numeric_limits<double>::infinity()}, 0};
  for (int round = 0; round < max_rounds; ++round) {
    const double radius = radius_around(current.at.center, points);
    if (radius < best.sphere.radius) best.sphere = {current.at.center, radius};
    const auto farthest = std::max_element(points.begin(), points.end(), [&](const auto& a, const auto& b) {
      return distance_norm(a - current.at.center) < distance_norm(b - current.at.center);
    });
    Support wider = current.support;
    wider.points[wider.count++] = *farthest;
    const SmallSphere next = smallest_of(wider);
    if (!(next.radius > current.radius)) break;
    current = next;
  }
  best.min_radius = std::min(proved_min_radius(current), best.sphere.radius);
  return best;
}

EnclosingSphere enclosing_sphere(std::span<const glm::vec3> points) {
  const std::vector<glm::dvec3> wide(points.begin(), points.end());
  return enclosing_sphere(wide);
}

}  // namespace morphcl
