#include "morphcl/transform.hpp"

#include <fmt/core.h>

#include <cmath>
#include <string_view>
#include <utility>

#include "host/math/direction.hpp"
#include "host/math/finite.hpp"
#include "morphcl/error.hpp"
#include "morphcl/rotation.hpp"

namespace morphcl {

namespace {

constexpr std::string_view inverse_prefix = "inverse of ";

std::string text(const glm::dvec3& v) { return fmt::format("({}, {}, {})", v.x, v.y, v.z); }

template <typename... Values>
void require_finite(const char* step, const Values&... values) {
  if (!(is_finite(values) && ...))
    throw Error(ErrorKind::usage, "",
                fmt::format("{}: an argument is NaN or infinite; every number must be finite", step));
}

glm::dmat4 translation(const glm::dvec3& offset) {
  glm::dmat4 matrix(1.0);
  matrix[3] = glm::dvec4(offset, 1.0);
  return matrix;
}

// x -> X + S (x - X) = S x + (X - S X), the translation with one rounding.
glm::dmat4 scaling_about(const glm::dvec3& point, const glm::dvec3& factor) {
  glm::dmat4 matrix(1.0);
  for (int i = 0; i < 3; ++i) {
    matrix[i][i] = factor[i];
    matrix[3][i] = std::fma(-factor[i], point[i], point[i]) + 0.0;
  }
  return matrix;
}

TransformStep scaling_step(std::string name, std::string detail, const glm::dvec3& point, const glm::dvec3& factor) {
  TransformStep step{std::move(name), std::move(detail), scaling_about(point, factor), glm::dmat4(1.0), true};
  step.inverse = scaling_about(point, 1.0 / factor);
  step.invertible = is_finite(step.inverse);
  return step;
}

// The inverse by cofactors.
TransformStep general_step(std::string name, std::string detail, const glm::dmat4& matrix) {
  const auto inverse = try_affine_inverse(matrix);
  return {std::move(name), std::move(detail), matrix, inverse.value_or(glm::dmat4(1.0)), inverse.has_value()};
}

}  // namespace

CompositeTransform& CompositeTransform::add_step(TransformStep step) {
  if (!is_finite(step.matrix))
    throw Error(ErrorKind::usage, "", fmt::format("{} {} overflows; use smaller numbers", step.name, step.detail));
  steps_.push_back(std::move(step));
  return *this;
}

CompositeTransform& CompositeTransform::translate(const glm::dvec3& offset) {
  require_finite("translate", offset);
  return add_step({"translate", "by " + text(offset), translation(offset), translation(0.0 - offset), true});
}

CompositeTransform& CompositeTransform::scale(const glm::dvec3& factor) {
  require_finite("scale", factor);
  return add_step(scaling_step("scale", "by " + text(factor), glm::dvec3(0.0), factor));
}

CompositeTransform& CompositeTransform::scale_about(const glm::dvec3& point, const glm::dvec3& factor) {
  require_finite("scale_about", point, factor);
  return add_step(scaling_step("scale_about", fmt::format("point {} by {}", text(point), text(factor)), point, factor));
}

CompositeTransform& CompositeTransform::rotate(const char* name, const glm::dvec3& axis, double degrees) {
  require_finite(name, degrees);
  const glm::dmat4 matrix = rotation_about_line(glm::dvec3(0.0), axis, degrees);
  return add_step({name, fmt::format("{} degrees", degrees), matrix, glm::transpose(matrix), true});
}

CompositeTransform& CompositeTransform::rotate_x_degrees(double degrees) {
  return rotate("rotate_x_degrees", {1, 0, 0}, degrees);
}

CompositeTransform& CompositeTransform::rotate_y_degrees(double degrees) {
  return rotate("rotate_y_degrees", {0, 1, 0}, degrees);
}

CompositeTransform& CompositeTransform::rotate_z_degrees(double degrees) {
  return rotate("rotate_z_degrees", {0, 0, 1}, degrees);
}

CompositeTransform& CompositeTransform::rotate_about_axis(const glm::dvec3& from, const glm::dvec3& to,
                                                          double degrees) {
  require_finite("rotate_about_axis", from, to, degrees);
  if (from == to)
    throw Error(ErrorKind::usage, "",
                fmt::format("rotate_about_axis: both points are {}; an axis needs two different points", text(from)));
  const glm::dvec3 axis = direction_from_to(from, to).high;
  return add_step({"rotate_about_axis", fmt::format("from {} to {}, {} degrees", text(from), text(to), degrees),
                   rotation_about_line(from, axis, degrees), rotation_about_line(from, axis, -degrees), true});
}

CompositeTransform& CompositeTransform::shear(double xy, double xz, double yx, double yz, double zx, double zy) {
  require_finite("shear", xy, xz, yx, yz, zx, zy);
  glm::dmat4 matrix(1.0);
  matrix[1][0] = xy;
  matrix[2][0] = xz;
  matrix[0][1] = yx;
  matrix[2][1] = yz;
  matrix[0][2] = zx;
  matrix[1][2] = zy;
  return add_step(
      general_step("shear", fmt::format("xy {}, xz {}, yx {}, yz {}, zx {}, zy {}", xy, xz, yx, yz, zx, zy), matrix));
}

CompositeTransform& CompositeTransform::matrix_step(const glm::dmat4& affine) {
  require_finite("matrix", affine);
  const glm::dmat4 rows = glm::transpose(affine);
  if (rows[3] != glm::dvec4(0, 0, 0, 1))
    throw Error(ErrorKind::usage, "",
                fmt::format("matrix: the last row is {} {} {} {}; an affine matrix ends in 0 0 0 1", rows[3].x,
                            rows[3].y, rows[3].z, rows[3].w));
  std::string detail = "rows";
  for (int row = 0; row < 3; ++row)
    detail += fmt::format(" [{}, {}, {}, {}]", rows[row].x, rows[row].y, rows[row].z, rows[row].w);
  return add_step(general_step("matrix", std::move(detail), affine));
}

CompositeTransform& CompositeTransform::append(const CompositeTransform& after) {
  // By index and with the count taken first, so that a composite can be appended to itself.
  const std::size_t count = after.steps_.size();
  steps_.reserve(steps_.size() + count);
  for (std::size_t i = 0; i < count; ++i) steps_.push_back(after.steps_[i]);
  return *this;
}

glm::dmat4 CompositeTransform::matrix() const {
  glm::dmat4 product(1.0);
  for (const TransformStep& step : steps_) product = step.matrix * product;
  if (!is_finite(product))
    throw Error(ErrorKind::usage, "", "the product of the transform's steps overflows; use smaller numbers");
  return product;
}

CompositeTransform CompositeTransform::inverse() const {
  CompositeTransform inverted;
  inverted.steps_.reserve(steps_.size());
  for (std::size_t i = steps_.size(); i-- > 0;) {
    TransformStep step = steps_[i];
    if (!step.invertible)
      throw Error(ErrorKind::usage, "",
                  fmt::format("step {}, {} {}, has no inverse; leave it out or use no factor of 0", i + 1, step.name,
                              step.detail));
    std::swap(step.matrix, step.inverse);
    const bool was_inverse = step.name.rfind(inverse_prefix, 0) == 0;
    step.name = was_inverse ? step.name.substr(inverse_prefix.size()) : std::string(inverse_prefix) + step.name;
    inverted.steps_.push_back(std::move(step));
  }
  return inverted;
}

std::string CompositeTransform::to_string() const {
  std::string lines;
  for (std::size_t i = 0; i < steps_.size(); ++i)
    lines += fmt::format("{}. {} {}\n", i + 1, steps_[i].name, steps_[i].detail);
  return lines;
}

}  // namespace morphcl
