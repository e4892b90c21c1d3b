// What is odd about a scene as a whole, once it is complete.
#pragma once

#include "morphcl/scene.hpp"

namespace morphcl {

// Adds to scene.warnings: that there is nothing to draw, and which other scenes its models have; that the camera's up
// lies along its view, and which vector is used instead.
void warn_of_oddities(Scene& scene);

}  // namespace morphcl
