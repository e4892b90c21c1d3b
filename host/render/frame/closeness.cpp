#include "host/render/frame/closeness.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace morphcl::reference {

namespace {

constexpr float largest_closeness = 0x1p60f;
constexpr std::uint32_t bits_of_1 = 0x3f800000u;

std::uint32_t float_key(const TwoFloat& closeness) {
  const TwoFloat from_near = two_sum(1.0f, -closeness.high);
  float depth = from_near.high + (from_near.low - closeness.low);
  if (depth < 0.0f) depth = 0.0f;
  if (depth > 1.0f) depth = 1.0f;
  return bits_of_1 - std::bit_cast<std::uint32_t>(depth);
}

}  // namespace

TwoFloat closeness_of(float distance, const FramePlan& plan) {
  TwoFloat q{-distance, 0.0f};
  if (!plan.parallel) {
    const float quotient = plan.near / distance;
    q = {quotient, std::fma(-quotient, distance, plan.near) / distance};
  }
  const DepthBuffer& buffer = plan.depth_buffer;
  const TwoFloat closeness = (q - TwoFloat{buffer.far[0], buffer.far[1]}) * TwoFloat{buffer.scale[0], buffer.scale[1]};
  if (!(closeness.high >= -largest_closeness)) return {-largest_closeness, 0.0f};
  return closeness;
}

std::uint32_t key_of(const TwoFloat& closeness, DepthFormat format) {
  if (format == DepthFormat::forward_float) return float_key(closeness);
  const double most = steps_of(format);
  const auto steps_high = static_cast<float>(most), steps_low = static_cast<float>(most - double{steps_high});
  const TwoFloat steps = closeness * TwoFloat{steps_high, steps_low};
  const float high = std::min(steps.high < 0.0f ? 0.0f : steps.high, steps_high);
  const float whole = std::nearbyint(high);
  const std::int64_t key =
      static_cast<std::int64_t>(whole) + static_cast<std::int64_t>(std::nearbyint((high - whole) + steps.low));
  return static_cast<std::uint32_t>(std::clamp<std::int64_t>(key, 0, static_cast<std::int64_t>(most)));
}

float decoded_depth(std::uint32_t key, const DepthBuffer& buffer) {
  const float closeness = buffer.format == DepthFormat::forward_float
                              ? 1.0f - std::bit_cast<float>(bits_of_1 - key)
                              : static_cast<float>(key) / static_cast<float>(steps_of(buffer.format));
  return std::fma(closeness, buffer.span, buffer.far[0]);
}

}  // namespace morphcl::reference
