#include "host/scene/model/base_color.hpp"

#include <algorithm>
#include <cmath>

#include "morphcl/error.hpp"

namespace morphcl {

namespace {
constexpr int alpha_component = 3;
}

glm::dvec4 base_color_at(const Material& material, std::int64_t tick) {
  glm::dvec4 color = material.base_color;
  if (material.base_color_track.empty()) return color;
  material.base_color_track.evaluate(tick, &color.x);
  for (int c = 0; c < 4; ++c) {
    if (!std::isfinite(color[c]))
      throw Error(ErrorKind::bad_input, "", "the base colour overflows; use smaller tangents");
    color[c] = c == alpha_component ? std::clamp(color[c], 0.0, 1.0) : std::max(color[c], 0.0);
  }
  return color;
}

bool moves_alpha(const Material& material) { return material.base_color_track.width() > alpha_component; }

}  // namespace morphcl
