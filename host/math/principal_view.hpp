// The views of technical drawing: world -> eye rotations of exact zeros and ones, to be used with an orthographic
// projection.
#pragma once

#include <glm/glm.hpp>

namespace morphcl {

// Named after the side that is seen. The world's y is up; front is seen from +z, right from +x, top from +y with -z up.
enum class PrincipalView { front, back, left, right, top, bottom };

// The eye is at the origin: an orthographic near distance may be negative so that the volume reaches behind it.
glm::dmat4 world_to_eye(PrincipalView view);

}  // namespace morphcl
