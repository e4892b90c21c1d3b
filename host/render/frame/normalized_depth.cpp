#include "host/render/frame/normalized_depth.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "host/render/frame/kernel_layout.hpp"

namespace morphcl::reference {

namespace {

constexpr std::uint32_t bits_of_1 = 0x3f800000u;

std::uint32_t float_key(const TwoFloat& normalized_depth) {
  const TwoFloat from_near = two_sum(1.0f, -normalized_depth.high);
  float depth = from_near.high + (from_near.low - normalized_depth.low);
  if (depth < 0.0f) depth = 0.0f;
  if (depth > 1.0f) depth = 1.0f;
  return bits_of_1 - std::bit_cast<std::uint32_t>(depth);
}

}  // namespace

TwoFloat normalized_depth_of(float distance, const FramePlan& plan) {
  TwoFloat q{-distance, 0.0f};
  if (!plan.camera.parallel) {
    const float quotient = plan.camera.near / distance;
    q = {quotient, std::fma(-quotient, distance, plan.camera.near) / distance};
  }
  const CameraConstants& camera = plan.camera;
  const TwoFloat normalized_depth =
      (q - TwoFloat{camera.depth_far[0], camera.depth_far[1]}) * TwoFloat{camera.depth_scale[0], camera.depth_scale[1]};
  if (!(normalized_depth.high >= -layout::max_normalized_depth)) return {-layout::max_normalized_depth, 0.0f};
  return normalized_depth;
}

std::uint32_t key_of(const TwoFloat& normalized_depth, DepthFormat format) {
  if (format == DepthFormat::forward_float) return float_key(normalized_depth);
  const double max_key = steps_of(format);
  const auto steps_high = static_cast<float>(max_key), steps_low = static_cast<float>(max_key - double{steps_high});
  const TwoFloat steps = normalized_depth * TwoFloat{steps_high, steps_low};
  const float high = std::min(steps.high < 0.0f ? 0.0f : steps.high, steps_high);
  const float whole = std::nearbyint(high);
  const std::int64_t key =
      static_cast<std::int64_t>(whole) + static_cast<std::int64_t>(std::nearbyint((high - whole) + steps.low));
  return static_cast<std::uint32_t>(std::clamp<std::int64_t>(key, 0, static_cast<std::int64_t>(max_key)));
}

float decoded_depth(std::uint32_t key, const FramePlan& plan) {
  const float normalized_depth = plan.depth_format == DepthFormat::forward_float
                                     ? 1.0f - std::bit_cast<float>(bits_of_1 - key)
                                     : static_cast<float>(key) / static_cast<float>(steps_of(plan.depth_format));
  return std::fma(normalized_depth, plan.camera.depth_span, plan.camera.depth_far[0]);
}

}  // namespace morphcl::reference
