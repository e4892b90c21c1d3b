#include "host/render/frame/depth_buffer.hpp"

#include <fmt/format.h>

#include <cmath>

#include "host/render/frame/kernel_layout.hpp"
#include "morphcl/error.hpp"
#include "morphcl/transform.hpp"

namespace morphcl {

namespace {

constexpr double max_parallel_distance = layout::max_clip_coordinate * 1e-3;
constexpr double min_relative_range = 0x1p-20;

void set_two_floats(double value, float (&rounded)[2]) {
  rounded[0] = to_fp32(value);
  rounded[1] = static_cast<float>(value - rounded[0]);
}

}  // namespace

void set_depth_buffer(DepthFormat format, double far, CameraConstants& camera) {
  if (!is_forward(format)) return;
  const bool parallel = camera.parallel != 0;
  const float near = parallel ? -camera.near_depth : camera.near;
  const double range = far - near, size = std::max(std::abs(double{near}), parallel ? std::abs(far) : 0.0);
  if (!(range > min_relative_range * size) || (parallel && size > max_parallel_distance))
    throw Error(ErrorKind::usage, "",
                fmt::format("near = {} and far = {} are too close together, or too far away, for a {} depth buffer; "
                            "reversed_float takes them",
                            near, far, name_of(format)));
  const double far_depth = parallel ? -double{to_fp32(far)} : near / far;
  const double span = (parallel ? -double{near} : 1.0) - far_depth;
  set_two_floats(far_depth, camera.depth_far);
  set_two_floats(1 / span, camera.depth_scale);
  camera.depth_span = to_fp32(span);
}

}  // namespace morphcl
