// The plane's pipeline of a scene that is seen along a world axis by parallel projectors: 3 x 3 matrices.
#pragma once

#include "morphcl/trace.hpp"

namespace morphcl {

// Sets trace.plane, where the camera is orthographic and looks along a world axis exactly. `world` is the point there,
// in morphcl's own convention.
void trace_plane(const CameraState& camera, const glm::dvec3& world, Trace& trace);

}  // namespace morphcl
