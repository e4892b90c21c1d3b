// Object -> world -> eye: the rigid transform of a camera.
//
// The up vector is repaired: only its part across the view axis is used (Kahan cross products). When it is 0 or closer
// to the view axis than 1e-12 radians, a fixed basis is used instead (the world axis least aligned with the view, ties
// to x, y, z in that order) and `up_replaced` reports it. Otherwise each entry of the rotation is within 16u64 of the
// exact one for the given numbers, however close up and view axis are.
#pragma once

#include <glm/glm.hpp>

namespace morphcl {

struct LookAt {
  glm::dmat4 world_to_eye;
  glm::dmat4 eye_to_world;  // by transpose, not by elimination
  bool up_replaced = false;
};

// Error(usage) when eye equals target, or anything is not finite.
LookAt look_at(const glm::dvec3& eye, const glm::dvec3& target, const glm::dvec3& up);

// From `eye` along `direction`, of any length; Error(usage) when it is 0, or anything is not finite.
LookAt look_along(const glm::dvec3& eye, const glm::dvec3& direction, const glm::dvec3& up);

}  // namespace morphcl
