// Tiny scenes that between them need every kernel: each shading, morph target form, light, projection and channel.
#pragma once

#include <vector>

#include "morphcl/scene.hpp"

namespace morphcl::cli {

std::vector<Scene> warm_scenes();

}  // namespace morphcl::cli
