#include "host/scene/gltf/gltf_quaternion.hpp"

#include <algorithm>
#include <cmath>

#include "morphcl/rotation.hpp"

namespace morphcl {

std::optional<double> normalize_quaternion(std::span<double, 4> q) {
  if (!std::all_of(q.begin(), q.end(), [](double component) { return std::isfinite(component); })) return std::nullopt;
  if (std::all_of(q.begin(), q.end(), [](double component) { return component == 0; })) return std::nullopt;
  const glm::dquat given(q[3], q[0], q[1], q[2]), unit = normalized(given);
  q[0] = unit.x;
  q[1] = unit.y;
  q[2] = unit.z;
  q[3] = unit.w;
  return glm::dot(given, unit);
}

}  // namespace morphcl
