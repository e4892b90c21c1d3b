#include "morphcl/transform.hpp"

#include <fmt/core.h>

#include <cmath>
#include <utility>

#include "morphcl/error.hpp"
#include "morphcl/numerics.hpp"

namespace morphcl {

namespace {

// About the coordinate axis `axis`: 0 is x, 1 is y, 2 is z.
TransformStep rotation(int axis, double sine, double cosine, const std::string& purpose) {
  const int i = (axis + 1) % 3, j = (axis + 2) % 3;
  glm::dmat4 matrix(1.0);
  matrix[i][i] = matrix[j][j] = cosine;
  matrix[i][j] = sine + 0.0;
  matrix[j][i] = 0.0 - sine;
  return {fmt::format("rotate_{}", "xyz"[axis]), fmt::format("sin {}, cos {}: {}", sine, cosine, purpose), matrix,
          glm::transpose(matrix), true};
}

TransformStep undone(TransformStep step, const std::string& detail) {
  std::swap(step.matrix, step.inverse);
  step.detail = detail;
  return step;
}

}  // namespace

CompositeTransform rotation_in_seven_steps(const glm::dvec3& from, const glm::dvec3& to, double degrees) {
  const glm::dvec3 axis = to - from;
  const double d = std::sqrt(axis.y * axis.y + axis.z * axis.z);
  const double length = std::sqrt(axis.x * axis.x + axis.y * axis.y + axis.z * axis.z);
  if (!(d > 0) || !std::isfinite(length))
    throw Error(ErrorKind::usage, "",
                fmt::format("rotation in seven steps: the axis from ({}, {}, {}) to ({}, {}, {}) {}; rotate_about_axis "
                            "has no such gap",
                            from.x, from.y, from.z, to.x, to.y, to.z,
                            axis == glm::dvec3(0.0)      ? "has length 0"
                            : axis.y == 0 && axis.z == 0 ? "is parallel to x, and step 2 divides by 0"
                                                         : "is so short or long that its squares leave fp64"));
  const TransformStep about_x = rotation(0, axis.y / d, axis.z / d, "the axis into the xz plane");
  const TransformStep about_y = rotation(1, -axis.x / length, d / length, "the axis onto z");
  const SinCos angle = sin_cos_degrees(degrees);
  CompositeTransform steps;
  steps.translate(0.0 - from)
      .add_step(about_x)
      .add_step(about_y)
      .add_step(rotation(2, angle.sin, angle.cos, fmt::format("{} degrees", degrees)))
      .add_step(undone(about_y, "step 3 undone"))
      .add_step(undone(about_x, "step 2 undone"))
      .translate(from);
  return steps;
}

}  // namespace morphcl
