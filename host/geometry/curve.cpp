// A curve through points, as lines.
#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <string>

#include "host/math/finite.hpp"
#include "morphcl/error.hpp"
#include "morphcl/solids.hpp"

namespace morphcl {

namespace {

void check_curve(std::span<const glm::dvec3> points, int v) {
  const auto refuse = [](const std::string& message) { throw Error(ErrorKind::usage, "", message); };
  if (points.size() < 2) refuse(fmt::format("a curve through {} points; two or more are needed", points.size()));
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!is_finite(points[i])) refuse(fmt::format("point {} of the curve is not finite", i));
  if (v < 1) refuse(fmt::format("{} edges from point to point; 1 or more are needed", v));
  if (points.size() - 1 > static_cast<std::size_t>(max_solid_vertices - 1) / static_cast<std::size_t>(v))
    refuse(fmt::format("{} edges between {} points make more than the {} vertices that are allowed", v, points.size(),
                       max_solid_vertices));
}

// Catmull and Rom: half the way from the point before to the one after; at the ends to the only neighbour.
glm::dvec3 tangent(std::span<const glm::dvec3> points, std::size_t i) {
  if (i == 0) return points[1] - points[0];
  if (i + 1 == points.size()) return points[i] - points[i - 1];
  return 0.5 * (points[i + 1] - points[i - 1]);
}

glm::dvec3 hermite(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& from, const glm::dvec3& to, double t) {
  const double rest = 1 - t;
  const double to_b = t * t * (3 - 2 * t);
  return a + to_b * (b - a) + t * rest * (rest * from - t * to);
}

}  // namespace

Mesh make_curve(std::span<const glm::dvec3> points, int v) {
  check_curve(points, v);
  Mesh mesh;
  mesh.name = "curve";
  mesh.positions.emplace_back(points[0]);
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const glm::dvec3 from = tangent(points, i), to = tangent(points, i + 1);
    for (int j = 1; j <= v; ++j) {
      const double t = static_cast<double>(j) / v;
      mesh.positions.emplace_back(j == v ? points[i + 1] : hermite(points[i], points[i + 1], from, to, t));
      const auto end = static_cast<glm::uint>(mesh.positions.size() - 1);
      mesh.edges.emplace_back(end - 1, end);
    }
  }
  return mesh;
}

}  // namespace morphcl
