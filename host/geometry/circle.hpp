// Points of a circle at even angles.
#pragma once

#include <cstddef>
#include <vector>

#include "morphcl/numerics.hpp"

namespace morphcl {

// `segments` + 1 angles from 0 to `degrees`, the last one exactly.
inline std::vector<SinCos> circle(int segments, double degrees) {
  std::vector<SinCos> points;
  points.reserve(static_cast<std::size_t>(segments) + 1);
  for (int i = 0; i <= segments; ++i) points.push_back(sin_cos_degrees(degrees * i / segments));
  return points;
}

}  // namespace morphcl
