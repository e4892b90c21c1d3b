// Products that nearly cancel, with the error of one rounding.
//
// Method: Kahan's difference of products with fma; Jeannerod, Louvet and Muller (2013) show an error of at most 1.5 ulp
// and 2u relative, barring overflow and underflow. Naive evaluation has no bound at all.
#pragma once

#include <cmath>
#include <glm/glm.hpp>

namespace morphcl {

// a * b - c * d. T is float or double.
template <typename T>
T difference_of_products(T a, T b, T c, T d) {
  const T cd = c * d;
  const T rounding_of_cd = std::fma(-c, d, cd);
  return std::fma(a, b, -cd) + rounding_of_cd;
}

// a x b, each component within 2u relative of the exact one, also for nearly parallel vectors.
template <typename T>
glm::vec<3, T> kahan_cross(const glm::vec<3, T>& a, const glm::vec<3, T>& b) {
  return {difference_of_products(a.y, b.z, a.z, b.y), difference_of_products(a.z, b.x, a.x, b.z),
          difference_of_products(a.x, b.y, a.y, b.x)};
}

}  // namespace morphcl
