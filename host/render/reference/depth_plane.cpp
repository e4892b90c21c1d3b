#include "host/render/reference/depth_plane.hpp"

namespace morphcl::reference {

namespace {
constexpr float pixel_width = layout::subpixels;
}

ReversedPlane::ReversedPlane(const ScreenVertex& a, const ScreenVertex& b, const ScreenVertex& c, std::int64_t area)
    : a_(a),
      d1x_(b.x - a.x),
      d1y_(b.y - a.y),
      d2x_(c.x - a.x),
      d2y_(c.y - a.y),
      d1_(b.depth - a.depth),
      d2_(c.depth - a.depth),
      inverse_area_(1.0f / static_cast<float>(area)) {
  dx_ = std::fma(static_cast<float>(d2y_), d1_, -(static_cast<float>(d1y_) * d2_)) * inverse_area_ * pixel_width;
  dy_ = std::fma(static_cast<float>(d1x_), d2_, -(static_cast<float>(d2x_) * d1_)) * inverse_area_ * pixel_width;
}

StoredDepth ReversedPlane::at(int x, int y, SampleOffset sample, int origin_x, int origin_y) const {
  const std::int64_t ox = pixel_centre(origin_x) - a_.x, oy = pixel_centre(origin_y) - a_.y;
  const float part1 = static_cast<float>(ox * d2y_ - oy * d2x_) * inverse_area_;
  const float part2 = static_cast<float>(oy * d1x_ - ox * d1y_) * inverse_area_;
  const float origin = std::fma(part1, d1_, std::fma(part2, d2_, a_.depth));
  return {std::fma(dx_, static_cast<float>(x - origin_x) + sample.pixels_x(),
                   std::fma(dy_, static_cast<float>(y - origin_y) + sample.pixels_y(), origin))};
}

StoredDepth ReversedPlane::beside_centre(int x, int y, SampleOffset sample, int origin_x, int origin_y) const {
  const float centre = at(x, y, {0, 0}, origin_x, origin_y).depth;
  return {std::fma(dx_, sample.pixels_x(), std::fma(dy_, sample.pixels_y(), centre))};
}

NormalizedDepthPlane::NormalizedDepthPlane(const FramePlan& plan, const ScreenVertex& a, const ScreenVertex& b,
                                           const ScreenVertex& c, std::int64_t area)
    : plan_(plan),
      a_(a),
      d1x_(b.x - a.x),
      d1y_(b.y - a.y),
      d2x_(c.x - a.x),
      d2y_(c.y - a.y),
      area_(area),
      min_(~0u),
      max_(0),
      in_range_(true) {
  const ScreenVertex* const corners[3] = {&a, &b, &c};
  for (int i = 0; i < 3; ++i) {
    const TwoFloat normalized_depth = normalized_depth_of(corners[i]->depth, plan);
    const std::uint32_t key = key_of(normalized_depth, plan_.depth_format);
    min_ = std::min(min_, key);
    max_ = std::max(max_, key);
    in_range_ = in_range_ && normalized_depth.high >= 0.0f;
    over_area_[i] = normalized_depth / from_integer(area);
  }
}

StoredDepth NormalizedDepthPlane::at(int x, int y, SampleOffset sample) const {
  const std::int64_t px = pixel_centre(x) + sample.subpixels_x() - a_.x,
                     py = pixel_centre(y) + sample.subpixels_y() - a_.y;
  const std::int64_t part_b = px * d2y_ - py * d2x_, part_c = py * d1x_ - px * d1y_, part_a = area_ - part_b - part_c;
  const TwoFloat normalized_depth = from_integer(part_a) * over_area_[0] +
                                    (from_integer(part_b) * over_area_[1] + from_integer(part_c) * over_area_[2]);
  const std::uint32_t key = std::min(std::max(key_of(normalized_depth, plan_.depth_format), min_), max_);
  return {decoded_depth(key, plan_), key, in_range_ || normalized_depth.high >= 0.0f};
}

StoredDepth depth_on_line(const FramePlan& plan, const ScreenVertex& a, const ScreenVertex& b, std::int64_t offset,
                          std::int64_t run) {
  if (!is_forward(plan.depth_format))
    return {std::fma(static_cast<float>(offset) / static_cast<float>(run), b.depth - a.depth, a.depth)};
  const TwoFloat start = normalized_depth_of(a.depth, plan), end = normalized_depth_of(b.depth, plan);
  const TwoFloat normalized_depth =
      (start * from_integer(run - offset) + end * from_integer(offset)) / from_integer(run);
  const std::uint32_t key = key_of(normalized_depth, plan.depth_format);
  return {decoded_depth(key, plan), key, normalized_depth.high >= 0.0f};
}

}  // namespace morphcl::reference
