// A camera from a model file in an image of other proportions.
#pragma once

#include <optional>

#include "morphcl/timeline.hpp"

namespace morphcl {

// All that the perspective was made to show stays in the image: where that is narrower than `authored_aspect`, the
// authored width is kept and more shows above and below, else the authored height. Nothing changes without an aspect.
void keep_authored_view(Camera& camera, std::optional<double> authored_aspect, double image_aspect);

}  // namespace morphcl
