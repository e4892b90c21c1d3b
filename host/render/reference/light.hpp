// The reference's view of kernels/light.h and kernels/light_faces.h.
#pragma once

#include <glm/glm.hpp>

#include "host/render/frame/frame_plan.hpp"

namespace morphcl::reference {

float difference_of_products(float a, float b, float c, float d);  // a b - c d

// Ambient light plus every light's share; normal of any length, zero: ambient only.
glm::vec3 lambert(const FramePlan& plan, const glm::vec3& normal, const glm::vec3& eye_position);

// Of a flat triangle, from its morphed corners in object space; in eye space.
struct Face {
  glm::vec3 normal;  // its largest component is 1 or -1; zero without area. Towards the eye on a double-sided draw
  glm::vec3 centre;
};
Face face_of(const FramePlan& plan, const Draw& draw, const glm::vec3& a, const glm::vec3& b, const glm::vec3& c);

}  // namespace morphcl::reference
