#include "morphcl/camera.hpp"

#include <fmt/core.h>

#include <cmath>

#include "host/math/direction.hpp"
#include "host/math/finite.hpp"
#include "host/math/kahan.hpp"
#include "morphcl/error.hpp"
#include "morphcl/transform.hpp"

namespace morphcl {

namespace {

constexpr double min_angle = 1e-12;  // radians between up and the view axis

glm::dvec3 transverse_axis(const glm::dvec3& direction) {
  const glm::dvec3 size = glm::abs(direction);
  if (size.x <= size.y && size.x <= size.z) return {1, 0, 0};
  if (size.y <= size.z) return {0, 1, 0};
  return {0, 0, 1};
}

void require_finite(const char* name, const glm::dvec3& vector) {
  if (!is_finite(vector))
    throw Error(ErrorKind::usage, "", fmt::format("the camera's {} is NaN or infinite; give finite numbers", name));
}

// `backward` points from the target to the eye and is not 0.
LookAt from_backward(const glm::dvec3& eye, const Difference& backward, const glm::dvec3& up) {
  const ScaledVector high = scale_to_one(backward.high);
  const auto scaled_low = [&](double low) { return std::ldexp(low, -high.exponent); };
  const glm::dvec3 low(scaled_low(backward.low.x), scaled_low(backward.low.y), scaled_low(backward.low.z));
  const glm::dvec3 up_scaled = scale_to_one(up).vector;

  // The low part matters where up is nearly parallel to the view: there it decides what is left of the product.
  glm::dvec3 across = kahan_cross(up_scaled, high.vector) + kahan_cross(up_scaled, low);
  LookAt result;
  result.up_replaced = !(glm::length(across) > min_angle * glm::length(up_scaled) * glm::length(high.vector));
  if (result.up_replaced) across = kahan_cross(transverse_axis(high.vector), high.vector);

  const glm::dvec3 x = unit(across), z = unit(high.vector), y = kahan_cross(z, x);
  // Adding 0 turns -0 into +0.
  result.eye_to_world =
      glm::dmat4(glm::dvec4(x + 0.0, 0), glm::dvec4(y + 0.0, 0), glm::dvec4(z + 0.0, 0), glm::dvec4(eye, 1));
  result.world_to_eye = rigid_inverse(result.eye_to_world);
  if (!is_finite(result.world_to_eye))
    throw Error(ErrorKind::usage, "",
                "the camera is so far away that its transform overflows; move the scene to the origin");
  return result;
}

}  // namespace

LookAt look_at(const glm::dvec3& eye, const glm::dvec3& target, const glm::dvec3& up) {
  require_finite("eye", eye);
  require_finite("target", target);
  require_finite("up", up);
  if (eye == target)
    throw Error(
        ErrorKind::usage, "",
        fmt::format("the camera's eye and target are both ({}, {}, {}); they must differ", eye.x, eye.y, eye.z));
  return from_backward(eye, direction_from_to(target, eye), up);
}

LookAt look_along(const glm::dvec3& eye, const glm::dvec3& direction, const glm::dvec3& up) {
  require_finite("eye", eye);
  require_finite("direction", direction);
  require_finite("up", up);
  if (direction == glm::dvec3(0.0))
    throw Error(ErrorKind::usage, "", "the camera's direction is 0; it must point somewhere");
  return from_backward(eye, {-direction, glm::dvec3(0.0)}, up);
}

}  // namespace morphcl
