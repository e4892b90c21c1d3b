// What a camera sees, as planes of clip space, and the numbers from which renderers measure depth.
#pragma once

#include <array>
#include <glm/glm.hpp>

#include "host/render/frame/camera_constants.hpp"
#include "morphcl/projection.hpp"

namespace morphcl {

// Depth, perspective: reversed and without a far plane in the matrix, depth = near / w, 1 on the near plane, 0 at
// infinity, so fp32 is dense where the distances are large. Parallel: depth = z in eye space.
struct ViewVolume {
  glm::dmat4 eye_to_ndc, eye_to_clip;  // rows of clip space: x, y, depth * w, w
  CameraConstants camera{};            // but for ray and slant, which depend on the picture, and the depth buffer
  // Planes of clip space, inside where dot(plane, point) > 0.
  std::array<glm::dvec4, 6> view;  // near, far, and the picture's edges: what is outside one of them shows nowhere
  std::array<glm::dvec4, 5> clip;  // near, and the guard band: what is inside all of them is not clipped
};

// The view reaches `margin` pixels beyond the picture: so far what is drawn may be from the points it is drawn for.
// Error(bad_input) when a perspective's near plane is closer than 1e-30.
ViewVolume make_view_volume(const Projection& projection, int width, int height, double margin = 0);

}  // namespace morphcl
