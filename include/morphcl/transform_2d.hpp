// The plane's pipeline: world -> view -> NDC -> viewport with 3 x 3 matrices, and composite transforms of the plane.
//
// Column vectors (x, y, 1); angles in degrees, counter-clockwise, exact at multiples of 90. Steps apply in the order
// they are added. What transform.hpp says of CompositeTransform and projection.hpp of Window and Viewport holds here
// too.
#pragma once

#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "morphcl/projection.hpp"
#include "morphcl/transform.hpp"

#pragma GCC visibility push(default)
namespace morphcl {

struct TransformStep2d {
  std::string name;    // "rotate_about_degrees"
  std::string detail;  // "point (1, 2), 30 degrees"
  glm::dmat3 matrix;   // affine
};

// Every adder throws Error(usage) for a NaN or infinite argument, and where its matrix overflows. There is no
// inverse(): affine_inverse(matrix()).
class CompositeTransform2d {
 public:
  CompositeTransform2d& translate(const glm::dvec2& offset);
  CompositeTransform2d& translate(const glm::dvec3& offset) = delete;  // GLM would drop z
  CompositeTransform2d& scale(const glm::dvec2& factor);
  CompositeTransform2d& scale(const glm::dvec3& factor) = delete;
  CompositeTransform2d& scale_about(const glm::dvec2& point, const glm::dvec2& factor);  // X + S (x - X)
  CompositeTransform2d& rotate_degrees(double degrees);
  CompositeTransform2d& rotate_about_degrees(const glm::dvec2& point, double degrees);
  CompositeTransform2d& shear(double xy, double yx);  // x' = x + xy*y, y' = y + yx*x

  const std::vector<TransformStep2d>& steps() const { return steps_; }
  glm::dmat3 matrix() const;      // error when the product overflows
  std::string to_string() const;  // one numbered line a step: name and detail

 private:
  CompositeTransform2d& add(TransformStep2d step);
  std::vector<TransformStep2d> steps_;
};

// The inverse of an affine map of the plane, its determinant by Kahan's difference of products. Error(usage) when the
// map is singular or the inverse overflows.
glm::dmat3 affine_inverse(const glm::dmat3& affine);

// World -> view: the view's origin is `centre`, its axes are turned by `degrees`, counter-clockwise.
glm::dmat3 world_to_view(const glm::dvec2& centre, double degrees);
// View -> NDC: the window becomes [-1, 1] x [-1, 1]. Error(usage) for an empty or infinite one.
glm::dmat3 view_to_ndc(const Window& window);
// NDC -> pixels, y downwards, as Viewport::to_pixels. Error(usage) for an empty or infinite one.
glm::dmat3 ndc_to_pixels(const Viewport& viewport);
// All three, the window widened to the viewport's proportions. Error(usage) for an empty or infinite window or
// viewport.
glm::dmat3 world_to_pixels(const glm::dvec2& centre, double degrees, const Window& window, const Viewport& viewport);

}  // namespace morphcl
#pragma GCC visibility pop
