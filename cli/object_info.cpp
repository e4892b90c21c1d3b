#include "cli/object_info.hpp"

#include <fmt/core.h>

#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

#include "morphcl/error.hpp"
#include "morphcl/numerics.hpp"
#include "morphcl/transform.hpp"

namespace morphcl::cli {

namespace {

// A part this close to doing nothing shows rounding, not intent.
constexpr double rounding = 1e-14;

bool is_near(const glm::dvec3& a, const glm::dvec3& b) {
  const glm::dvec3 d = glm::abs(a - b);
  return d.x <= rounding && d.y <= rounding && d.z <= rounding;
}

// Six digits; what rounding left of a 0 is one.
std::string numbers(const glm::dvec3& v) {
  const auto shown = [](double x) { return std::abs(x) <= rounding ? 0.0 : x; };
  return fmt::format("({:.6g}, {:.6g}, {:.6g})", shown(v.x), shown(v.y), shown(v.z));
}

std::string turn(const glm::dmat3& rotation) {
  const glm::dquat q = glm::quat_cast(rotation);
  const glm::dvec3 axis(q.x, q.y, q.z);
  const double length = glm::length(axis);
  if (length <= rounding) return "";
  return fmt::format(", turned {:.6g} degrees about {}", degrees(2 * arc_tangent(length, std::abs(q.w))),
                     numbers(axis * ((q.w < 0 ? -1 : 1) / length)));
}

}  // namespace

std::string describe_placement(const Object& object, NodeSampler& nodes) try {
  const Decomposition parts = decompose(nodes.to_world(object.node));
  std::string text = "at " + numbers(parts.translation) + turn(parts.rotation);
  if (!is_near(parts.shear, glm::dvec3(0))) text += ", sheared by xy, xz, yz " + numbers(parts.shear);
  if (!is_near(parts.scale, glm::dvec3(1))) text += ", scaled " + numbers(parts.scale);
  return text + fmt::format("; put together again within {:.1g}", parts.residual);
} catch (const Error& error) {
  return "not to be taken apart: " + error.message();
}

}  // namespace morphcl::cli
