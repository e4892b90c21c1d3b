#include "morphcl/transform_2d.hpp"

#include <fmt/core.h>

#include <cmath>
#include <utility>

#include "host/math/finite.hpp"
#include "host/math/kahan.hpp"
#include "host/math/require_number.hpp"
#include "morphcl/error.hpp"
#include "morphcl/rotation.hpp"

namespace morphcl {

namespace {

std::string text(const glm::dvec2& v) { return fmt::format("({}, {})", v.x, v.y); }

// From rows of the 2 x 2 part, which act on (x, y), and the translation.
glm::dmat3 affine(double xx, double xy, double yx, double yy, const glm::dvec2& translation) {
  return {{xx, yx, 0}, {xy, yy, 0}, {translation + 0.0, 1}};
}

glm::dmat3 rotation_about(const glm::dvec2& point, double degrees) {
  const AxisRotation r = axis_rotation({0, 0, 1}, degrees);
  const glm::dmat3 &m = r.matrix, &rest = r.identity_minus;
  return affine(
      m[0][0], m[1][0], m[0][1], m[1][1],
      {std::fma(rest[0][0], point.x, rest[1][0] * point.y), std::fma(rest[0][1], point.x, rest[1][1] * point.y)});
}

glm::dmat3 scaling_about(const glm::dvec2& point, const glm::dvec2& factor) {
  return affine(factor.x, 0, 0, factor.y,
                {std::fma(-factor.x, point.x, point.x), std::fma(-factor.y, point.y, point.y)});
}

glm::dmat3 require_finite(const glm::dmat3& matrix, const std::string& what) {
  if (!is_finite(matrix)) throw Error(ErrorKind::usage, "", what + " is not finite; use finite and smaller numbers");
  return matrix;
}

}  // namespace

CompositeTransform2d& CompositeTransform2d::add(TransformStep2d step) {
  require_finite(step.matrix, step.name + " " + step.detail);
  steps_.push_back(std::move(step));
  return *this;
}

CompositeTransform2d& CompositeTransform2d::translate(const glm::dvec2& offset) {
  return add({"translate", "by " + text(offset), affine(1, 0, 0, 1, offset)});
}

CompositeTransform2d& CompositeTransform2d::scale(const glm::dvec2& factor) {
  return add({"scale", "by " + text(factor), scaling_about(glm::dvec2(0.0), factor)});
}

CompositeTransform2d& CompositeTransform2d::scale_about(const glm::dvec2& point, const glm::dvec2& factor) {
  return add({"scale_about", fmt::format("point {} by {}", text(point), text(factor)), scaling_about(point, factor)});
}

CompositeTransform2d& CompositeTransform2d::rotate_degrees(double degrees) {
  require_number(std::isfinite(degrees), "degrees", degrees, "finite");
  return add({"rotate_degrees", fmt::format("{} degrees", degrees), rotation_about(glm::dvec2(0.0), degrees)});
}

CompositeTransform2d& CompositeTransform2d::rotate_about_degrees(const glm::dvec2& point, double degrees) {
  require_number(std::isfinite(degrees), "degrees", degrees, "finite");
  return add({"rotate_about_degrees", fmt::format("point {}, {} degrees", text(point), degrees),
              rotation_about(point, degrees)});
}

CompositeTransform2d& CompositeTransform2d::shear(double xy, double yx) {
  return add({"shear", fmt::format("xy {}, yx {}", xy, yx), affine(1, xy, yx, 1, glm::dvec2(0.0))});
}

glm::dmat3 CompositeTransform2d::matrix() const {
  glm::dmat3 product(1.0);
  for (const TransformStep2d& step : steps_) product = step.matrix * product;
  return require_finite(product, "the product of the transform's steps");
}

std::string CompositeTransform2d::to_string() const {
  std::string lines;
  for (std::size_t i = 0; i < steps_.size(); ++i)
    lines += fmt::format("{}. {} {}\n", i + 1, steps_[i].name, steps_[i].detail);
  return lines;
}

glm::dmat3 affine_inverse(const glm::dmat3& m) {
  const double determinant = difference_of_products(m[0][0], m[1][1], m[1][0], m[0][1]);
  const double xx = m[1][1] / determinant, xy = 0.0 - m[1][0] / determinant;
  const double yx = 0.0 - m[0][1] / determinant, yy = m[0][0] / determinant;
  // -(xx tx + xy ty) as a difference, which Kahan's form computes within 2u.
  const glm::dvec2 translation(difference_of_products(-xy, m[2][1], xx, m[2][0]),
                               difference_of_products(-yx, m[2][0], yy, m[2][1]));
  const glm::dmat3 inverse = affine(xx, xy, yx, yy, translation);
  if (!is_finite(inverse))
    throw Error(ErrorKind::usage, "", "a transform of the plane has no inverse; no scale in it may be 0");
  return inverse;
}

glm::dmat3 world_to_view(const glm::dvec2& centre, double degrees) {
  return CompositeTransform2d().translate(0.0 - centre).rotate_degrees(-degrees).matrix();
}

glm::dmat3 view_to_ndc(const Window& w) {
  require_number(w.right > w.left && std::isfinite(w.right - w.left), "right", w.right, "greater than left and finite");
  require_number(w.top > w.bottom && std::isfinite(w.top - w.bottom), "top", w.top, "greater than bottom and finite");
  const double half_width = 0.5 * w.right - 0.5 * w.left, half_height = 0.5 * w.top - 0.5 * w.bottom;
  return require_finite(
      affine(1 / half_width, 0, 0, 1 / half_height,
             {0.0 - (0.5 * w.left + 0.5 * w.right) / half_width, 0.0 - (0.5 * w.bottom + 0.5 * w.top) / half_height}),
      "the window's scale");
}

glm::dmat3 ndc_to_pixels(const Viewport& v) {
  require_number(v.width > 0 && std::isfinite(v.width), "the viewport's width", v.width, "positive and finite");
  require_number(v.height > 0 && std::isfinite(v.height), "the viewport's height", v.height, "positive and finite");
  return affine(0.5 * v.width, 0, 0, -0.5 * v.height, {v.x + 0.5 * v.width, v.y + 0.5 * v.height});
}

glm::dmat3 world_to_pixels(const glm::dvec2& centre, double degrees, const Window& window, const Viewport& viewport) {
  const glm::dmat3 to_pixels = ndc_to_pixels(viewport);
  const Window shown = fitted(window, Fit::widen, viewport.width / viewport.height).window;
  return require_finite(to_pixels * view_to_ndc(shown) * world_to_view(centre, degrees), "the way to the pixels");
}

}  // namespace morphcl
