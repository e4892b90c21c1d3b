// One key of a shot's track on its way from the file to a Track.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>

#include "host/scene/shot/shot_value.hpp"

namespace morphcl {

using KeyComponents = std::array<double, 4>;  // as many as the track is wide are used

struct AxisAngle {
  glm::dvec3 axis;  // as written, not 0
  double degrees;
};

struct TrackKey {
  ShotValue source;
  std::int64_t tick = 0;
  double frame = 0;
  KeyComponents value{};
  KeyComponents in_tangent{}, out_tangent{};  // change per frame
  bool has_tangents = false;
  std::optional<AxisAngle> turn = std::nullopt;  // the value of a rotation key, when it was written so
};

}  // namespace morphcl
