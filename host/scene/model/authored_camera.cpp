#include "host/scene/model/authored_camera.hpp"

#include "morphcl/numerics.hpp"

namespace morphcl {

void keep_authored_view(Camera& camera, std::optional<double> authored_aspect, double image_aspect) {
  constexpr double noise = 1e-5;  // of aspects that were written in fp32
  const auto* lens = std::get_if<Perspective>(&camera.projection);
  if (!lens || !authored_aspect || !(image_aspect < *authored_aspect * (1 - noise))) return;
  const SinCos half = sin_cos_degrees(lens->fovy_degrees / 2);
  HorizontalPerspective wide;
  wide.fovx_degrees = 2 * degrees(arc_tangent(half.sin * *authored_aspect, half.cos));
  wide.near = lens->near;
  wide.far = lens->far;
  camera.projection = wide;
}

}  // namespace morphcl
