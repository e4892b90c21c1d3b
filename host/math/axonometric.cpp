#include "morphcl/camera.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "host/math/direction.hpp"
#include "host/math/finite.hpp"
#include "morphcl/error.hpp"
#include "morphcl/numerics.hpp"

namespace morphcl {

namespace {

template <typename... Values>
[[noreturn]] void refuse(const char* message, Values... values) {
  throw Error(ErrorKind::usage, "", fmt::format(fmt::runtime(message), values...));
}

// `horizontal` is the length of (n.x, n.z).
ViewDirection upright(const glm::dvec3& n, double horizontal) {
  if (horizontal == 0) return {n, {0, 0, n.y > 0 ? -1 : 1}};  // top and bottom as the principal views have them
  // Adding 0 turns -0 into +0.
  return {n, glm::dvec3(-n.x / horizontal * n.y, horizontal, -n.z / horizontal * n.y) + 0.0};
}

}  // namespace

ViewDirection view_from_angles(double azimuth_degrees, double elevation_degrees) {
  if (!(elevation_degrees >= -90 && elevation_degrees <= 90))
    refuse("elevation_degrees is {}; it must be between -90 and 90", elevation_degrees);
  const SinCos azimuth = sin_cos_degrees(azimuth_degrees), elevation = sin_cos_degrees(elevation_degrees);
  const glm::dvec3 n(azimuth.sin * elevation.cos, elevation.sin, azimuth.cos * elevation.cos);
  // From the angles and not from n, so that looking straight down keeps the azimuth.
  return {n + 0.0, glm::dvec3(-azimuth.sin * elevation.sin, elevation.cos, -azimuth.cos * elevation.sin) + 0.0};
}

ViewDirection view_from_ratios(const glm::dvec3& ratios) {
  const bool usable = is_finite(ratios) && ratios.x >= 0 && ratios.y >= 0 && ratios.z >= 0;
  const glm::dvec3 r = usable ? scale_to_one(ratios).vector : glm::dvec3(0.0);
  const double sum = r.x * r.x + r.y * r.y + r.z * r.z;
  glm::dvec3 squares;  // of n: (sum - 2 r_i^2) / sum
  for (int i = 0; i < 3; ++i) {
    const double a = r[i], b = r[(i + 1) % 3], c = r[(i + 2) % 3];
    squares[i] = std::fma(b - a, b + a, c * c) / sum;
  }
  if (!(squares.x >= 0 && squares.y >= 0 && squares.z >= 0))
    refuse(
        "ratios are ({}, {}, {}); each must be 0 or more, and the square of none more than those of the other two "
        "together",
        ratios.x, ratios.y, ratios.z);
  return upright(glm::sqrt(squares), std::sqrt(squares.x + squares.z));
}

ViewDirection view_from_axis_angles(double x_degrees, double z_degrees) {
  // What is left of a right angle, without rounding where it is small.
  const double rest = (90 - std::max(x_degrees, z_degrees)) - std::min(x_degrees, z_degrees);
  if (!(x_degrees >= 0 && z_degrees >= 0 && rest > 0 && rest < 90))
    refuse("the axes' angles are {} and {} degrees; each must be 0 or more, and their sum above 0 and below 90",
           x_degrees, z_degrees);
  // With azimuth a and elevation e, tan x = tan a sin e and tan z = cot a sin e: solved for the direction, times a
  // factor.
  const SinCos x = sin_cos_degrees(x_degrees), z = sin_cos_degrees(z_degrees), r = sin_cos_degrees(rest);
  const glm::dvec3 n =
      unit({std::sqrt(x.sin * z.cos * r.sin), std::sqrt(x.sin * z.sin * r.cos), std::sqrt(z.sin * x.cos * r.sin)});
  return upright(n, std::sqrt(std::fma(n.x, n.x, n.z * n.z)));
}

ViewDirection seen_from_corner(const ViewDirection& view, const glm::dvec3& corner) {
  if (glm::abs(corner) != glm::dvec3(1.0))
    refuse("corner is ({}, {}, {}); each number must be 1 or -1", corner.x, corner.y, corner.z);
  const glm::dvec3 n = glm::abs(view.towards_eye) * corner + 0.0;
  return upright(n, std::sqrt(std::fma(n.x, n.x, n.z * n.z)));
}

ViewDirection view_direction(PrincipalView view) {
  const glm::dmat4 rows = glm::transpose(world_to_eye(view));
  return {glm::dvec3(rows[2]), glm::dvec3(rows[1])};
}

glm::dvec3 foreshortening(const ViewDirection& view) {
  // sqrt(1 - n_i^2) without cancellation: the length of the other two components.
  const glm::dvec3& n = view.towards_eye;
  const auto length = [](double a, double b) { return std::sqrt(std::fma(a, a, b * b)); };
  return {length(n.y, n.z), length(n.x, n.z), length(n.x, n.y)};
}

}  // namespace morphcl
