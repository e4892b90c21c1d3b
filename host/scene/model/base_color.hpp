// The base colour of a material that may change over time.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>

#include "morphcl/scene.hpp"

namespace morphcl {

// At the tick. What a track overshoots to is brought back: red, green and blue to 0 or more, alpha to 0 to 1.
// Error(bad_input) when the track overflows.
glm::dvec4 base_color_at(const Material& material, std::int64_t tick);

// Its alpha changes over time.
bool moves_alpha(const Material& material);

}  // namespace morphcl
