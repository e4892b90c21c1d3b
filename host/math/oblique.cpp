#include "morphcl/projection.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "host/math/finite.hpp"
#include "morphcl/error.hpp"
#include "morphcl/numerics.hpp"

namespace morphcl {

ObliqueShear oblique_shear(double direction_degrees, double factor) {
  if (!(factor >= 0 && factor <= max_oblique_factor))
    throw Error(ErrorKind::usage, "",
                fmt::format("factor is {}; it must be between 0 and {:.5g}: beyond, the projectors run closer than {} "
                            "degree to the picture's plane, and rounding shows",
                            factor, max_oblique_factor, min_beta_degrees));
  const SinCos angle = sin_cos_degrees(direction_degrees);
  return {factor * angle.cos, factor * angle.sin};
}

double oblique_factor(double beta_degrees) {
  if (!(beta_degrees >= min_beta_degrees && beta_degrees <= 90))
    throw Error(ErrorKind::usage, "",
                fmt::format("beta_degrees is {}; it must be between {} and 90: the closer the projectors run to the "
                            "picture's plane, the more an error of the angle moves the picture",
                            beta_degrees, min_beta_degrees));
  const SinCos angle = sin_cos_degrees(beta_degrees);
  return std::min(angle.cos / angle.sin, max_oblique_factor);
}

ObliqueShear oblique_shear_along(const glm::dvec3& direction) {
  const ObliqueShear shear{direction.x / direction.z, direction.y / direction.z};
  if (!is_finite(direction) || !(std::sqrt(shear.x * shear.x + shear.y * shear.y) <= max_oblique_factor))
    throw Error(ErrorKind::usage, "",
                fmt::format("the projectors' direction is ({}, {}, {}); it must be finite and lead through the "
                            "picture's plane z = 0 at {} degree or more",
                            direction.x, direction.y, direction.z, min_beta_degrees));
  return shear;
}

}  // namespace morphcl
