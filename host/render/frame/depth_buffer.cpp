#include "host/render/frame/depth_buffer.hpp"

#include <fmt/format.h>

#include <cmath>

#include "host/error.hpp"
#include "host/math/rounding.hpp"

namespace morphcl {

namespace {

constexpr double farthest_parallel_plane = 1e30;  // clip coordinates are below 1e33
constexpr double least_relative_range = 0x1p-20;

std::array<float, 2> two_floats(double value) {
  const float high = to_fp32(value);
  return {high, static_cast<float>(value - high)};
}

}  // namespace

DepthBuffer make_depth_buffer(DepthFormat format, float near, double far, bool parallel) {
  DepthBuffer buffer;
  buffer.format = format;
  if (!buffer.is_forward()) return buffer;
  const double range = far - near, size = std::max(std::abs(double{near}), parallel ? std::abs(far) : 0.0);
  if (!(range > least_relative_range * size) || (parallel && size > farthest_parallel_plane))
    throw Error(ErrorKind::usage, "",
                fmt::format("near = {} and far = {} are too close together, or too far away, for a {} depth buffer; "
                            "reversed_float takes them",
                            near, far, name_of(format)));
  const double far_depth = parallel ? -double{to_fp32(far)} : near / far;
  const double span = (parallel ? -double{near} : 1.0) - far_depth;
  buffer.far = two_floats(far_depth);
  buffer.scale = two_floats(1 / span);
  buffer.span = to_fp32(span);
  return buffer;
}

}  // namespace morphcl
