#include "morphcl/projection.hpp"

#include <cmath>

namespace morphcl {

namespace {

constexpr double min_slope = 0x1p-40;

}  // namespace

VanishingPoints vanishing_points(const Projection& projection, double aspect, const glm::dmat4& world_to_eye) {
  VanishingPoints points;
  if (is_parallel(projection)) return points;
  const glm::dmat4 eye_to_ndc = projection_matrix(projection, aspect);
  for (int axis = 0; axis < 3; ++axis) {
    const glm::dvec4 direction(glm::dvec3(world_to_eye[axis]), 0);
    if (!(std::abs(direction.z) >= min_slope)) continue;
    const glm::dvec4 image = eye_to_ndc * direction;
    points[static_cast<std::size_t>(axis)] = glm::dvec2(image) / image.w + 0.0;
  }
  return points;
}

int count(const VanishingPoints& points) {
  int found = 0;
  for (const auto& point : points) found += point.has_value();
  return found;
}

}  // namespace morphcl
