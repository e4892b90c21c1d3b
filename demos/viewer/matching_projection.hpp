// Parallel and central projections that show the same size, and six-plane projections that fit an aspect.
#pragma once

#include "morphcl/projection.hpp"

namespace morphcl::viewer {

// The orthographic projection that shows the plane `distance` (> 0) in front of the eye as `projection` does, between
// the same near and far planes; an orthographic one is returned as it is. An infinite far plane is brought to a finite
// one.
Orthographic matching_orthographic(const Projection& projection, double distance, double aspect);

// The same for a frustum. A near plane behind or at the eye is brought to a thousandth of `distance`.
Frustum matching_frustum(const Projection& projection, double distance, double aspect);

// A parallel projection whose window, as the image shows it, is `factor` times as large about the view axis.
Projection zoomed(const Projection& projection, double factor, double aspect);

// `planes` with left and right, or bottom and top, moved outwards about their middle until the near plane has this
// aspect; the same bits where it has it already.
Orthographic widened(const Orthographic& planes, double aspect);
Frustum widened(const Frustum& planes, double aspect);

}  // namespace morphcl::viewer
