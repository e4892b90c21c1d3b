#include "host/render/reference/depth_plane.hpp"

namespace morphcl::reference {

ReversedPlane::ReversedPlane(const ScreenVertex& a, const ScreenVertex& b, const ScreenVertex& c, std::int64_t area)
    : a_(a),
      d1x_(b.x - a.x),
      d1y_(b.y - a.y),
      d2x_(c.x - a.x),
      d2y_(c.y - a.y),
      d1_(b.depth - a.depth),
      d2_(c.depth - a.depth),
      inverse_area_(1.0f / static_cast<float>(area)) {
  dx_ = std::fma(static_cast<float>(d2y_), d1_, -(static_cast<float>(d1y_) * d2_)) * inverse_area_ * 256.0f;
  dy_ = std::fma(static_cast<float>(d1x_), d2_, -(static_cast<float>(d2x_) * d1_)) * inverse_area_ * 256.0f;
}

StoredDepth ReversedPlane::at(int x, int y, int origin_x, int origin_y) const {
  const std::int64_t ox = pixel_centre(origin_x) - a_.x, oy = pixel_centre(origin_y) - a_.y;
  const float part1 = static_cast<float>(ox * d2y_ - oy * d2x_) * inverse_area_;
  const float part2 = static_cast<float>(oy * d1x_ - ox * d1y_) * inverse_area_;
  const float origin = std::fma(part1, d1_, std::fma(part2, d2_, a_.depth));
  return {std::fma(dx_, static_cast<float>(x - origin_x), std::fma(dy_, static_cast<float>(y - origin_y), origin))};
}

ClosenessPlane::ClosenessPlane(const FramePlan& plan, const ScreenVertex& a, const ScreenVertex& b,
                               const ScreenVertex& c, std::int64_t area)
    : buffer_(plan.depth_buffer),
      a_(a),
      d1x_(b.x - a.x),
      d1y_(b.y - a.y),
      d2x_(c.x - a.x),
      d2y_(c.y - a.y),
      area_(area),
      least_(~0u),
      greatest_(0),
      in_range_(true) {
  const ScreenVertex* const corners[3] = {&a, &b, &c};
  for (int i = 0; i < 3; ++i) {
    const TwoFloat closeness = closeness_of(corners[i]->depth, plan);
    const std::uint32_t key = key_of(closeness, buffer_.format);
    least_ = std::min(least_, key);
    greatest_ = std::max(greatest_, key);
    in_range_ = in_range_ && closeness.high >= 0.0f;
    over_area_[i] = closeness / from_integer(area);
  }
}

StoredDepth ClosenessPlane::at(int x, int y) const {
  const std::int64_t px = pixel_centre(x) - a_.x, py = pixel_centre(y) - a_.y;
  const std::int64_t part_b = px * d2y_ - py * d2x_, part_c = py * d1x_ - px * d1y_, part_a = area_ - part_b - part_c;
  const TwoFloat closeness = from_integer(part_a) * over_area_[0] +
                             (from_integer(part_b) * over_area_[1] + from_integer(part_c) * over_area_[2]);
  const std::uint32_t key = std::min(std::max(key_of(closeness, buffer_.format), least_), greatest_);
  return {decoded_depth(key, buffer_), key, in_range_ || closeness.high >= 0.0f};
}

StoredDepth depth_on_line(const FramePlan& plan, const ScreenVertex& a, const ScreenVertex& b, std::int64_t offset,
                          std::int64_t run) {
  if (!plan.depth_buffer.is_forward())
    return {std::fma(static_cast<float>(offset) / static_cast<float>(run), b.depth - a.depth, a.depth)};
  const TwoFloat start = closeness_of(a.depth, plan), end = closeness_of(b.depth, plan);
  const TwoFloat closeness = (start * from_integer(run - offset) + end * from_integer(offset)) / from_integer(run);
  const std::uint32_t key = key_of(closeness, plan.depth_buffer.format);
  return {decoded_depth(key, plan.depth_buffer), key, closeness.high >= 0.0f};
}

}  // namespace morphcl::reference
