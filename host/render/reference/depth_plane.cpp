#include "host/render/reference/depth_plane.hpp"

#include "host/render/reference/light.hpp"

namespace morphcl::reference {

namespace {
constexpr float pixel_width = layout::subpixels;
constexpr float corner_units = layout::corner_units, corner_unit = 1.0f / corner_units;

float in_subpixels(std::int64_t units) { return static_cast<float>(units) * corner_unit; }

float rounded_difference(const TwoFloat& b, const TwoFloat& a) { return (b.high - a.high) + (b.low - a.low); }

}  // namespace

MirrorImages::MirrorImages(const ScreenVertex& a, const ScreenVertex& b, const ScreenVertex& c) : corner_{a, b, c} {
  for (int i = 0; i < 3; ++i) {
    const ScreenVertex& next = corner_[(i + 1) % 3];
    dx_[i] = in_subpixels(next.corner_x() - corner_[i].corner_x());
    dy_[i] = in_subpixels(next.corner_y() - corner_[i].corner_y());
  }
}

std::optional<float> MirrorImages::change_at(int x, int y, float dx, float dy) const {
  const std::int64_t px = std::int64_t{pixel_centre(x)} * layout::corner_units,
                     py = std::int64_t{pixel_centre(y)} * layout::corner_units;
  float value[3];
  for (int i = 0; i < 3; ++i)
    value[i] = difference_of_products(dx_[i], in_subpixels(py - corner_[i].corner_y()), dy_[i],
                                      in_subpixels(px - corner_[i].corner_x()));
  const bool turned = value[0] + value[1] + value[2] < 0.0f;
  std::optional<float> change;
  float farthest = 0.0f;
  for (int i = 0; i < 3; ++i) {
    if (turned ? !(value[i] > 0.0f) : !(value[i] < 0.0f)) continue;
    const float way = value[i] / std::fma(dx_[i], dx_[i], dy_[i] * dy_[i]), square = way * value[i];
    if (!(square > farthest)) continue;
    change = -2.0f * way * difference_of_products(dx_[i], dy, dy_[i], dx);
    farthest = square;
  }
  return change;
}

ReversedPlane::ReversedPlane(const ScreenVertex& a, const ScreenVertex& b, const ScreenVertex& c)
    : a_(a),
      min_(std::min({a.depth, b.depth, c.depth})),
      max_(std::max({a.depth, b.depth, c.depth})),
      mirror_images_(a, b, c) {
  const auto d1x = static_cast<float>(b.corner_x() - a.corner_x()),
             d1y = static_cast<float>(b.corner_y() - a.corner_y()),
             d2x = static_cast<float>(c.corner_x() - a.corner_x()),
             d2y = static_cast<float>(c.corner_y() - a.corner_y());
  // The differences are scaled down, and the area's inverse up, so that products do not overflow.
  const float depth1 = (b.depth - a.depth) * corner_unit, depth2 = (c.depth - a.depth) * corner_unit;
  const float area = difference_of_products(d1x, d2y, d2x, d1y);
  const float scale = area == 0.0f ? 0.0f : corner_units / area;
  unit_dx_ = difference_of_products(d2y, depth1, d1y, depth2) * scale;
  unit_dy_ = difference_of_products(d1x, depth2, d2x, depth1) * scale;
}

float ReversedPlane::on_plane(int x, int y, SampleOffset sample, int origin_x, int origin_y) const {
  const auto ox = static_cast<float>(std::int64_t{pixel_centre(origin_x)} * layout::corner_units - a_.corner_x()),
             oy = static_cast<float>(std::int64_t{pixel_centre(origin_y)} * layout::corner_units - a_.corner_y());
  const float origin = std::fma(unit_dx_, ox, std::fma(unit_dy_, oy, a_.depth));
  constexpr float pixel = corner_units * pixel_width;
  return std::fma(unit_dx_ * pixel, static_cast<float>(x - origin_x) + sample.pixels_x(),
                  std::fma(unit_dy_ * pixel, static_cast<float>(y - origin_y) + sample.pixels_y(), origin));
}

StoredDepth ReversedPlane::at_centre(int x, int y, int origin_x, int origin_y) const {
  float depth = on_plane(x, y, {0, 0}, origin_x, origin_y);
  if (const auto change = mirror_images_.change_at(x, y, unit_dx_ * corner_units, unit_dy_ * corner_units))
    depth += *change;
  return {within_corners(depth)};
}

StoredDepth ReversedPlane::at_sample(int x, int y, SampleOffset sample, int origin_x, int origin_y) const {
  return {on_plane(x, y, sample, origin_x, origin_y)};
}

StoredDepth ReversedPlane::at_sample_of_small(int x, int y, SampleOffset sample, int origin_x, int origin_y) const {
  const float centre = on_plane(x, y, {0, 0}, origin_x, origin_y);
  constexpr float pixel = corner_units * pixel_width;
  return {std::fma(unit_dx_ * pixel, sample.pixels_x(), std::fma(unit_dy_ * pixel, sample.pixels_y(), centre))};
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
      in_range_(true),
      mirror_images_(a, b, c) {
  const ScreenVertex* const corners[3] = {&a, &b, &c};
  TwoFloat at_corner[3];
  for (int i = 0; i < 3; ++i) {
    at_corner[i] = normalized_depth_of(corners[i]->depth, plan);
    const std::uint32_t key = key_of(at_corner[i], plan_.depth_format);
    min_ = std::min(min_, key);
    max_ = std::max(max_, key);
    in_range_ = in_range_ && at_corner[i].high >= 0.0f;
  }
  const float d1x = in_subpixels(b.corner_x() - a.corner_x()), d1y = in_subpixels(b.corner_y() - a.corner_y());
  const float d2x = in_subpixels(c.corner_x() - a.corner_x()), d2y = in_subpixels(c.corner_y() - a.corner_y());
  const float depth1 = rounded_difference(at_corner[1], at_corner[0]),
              depth2 = rounded_difference(at_corner[2], at_corner[0]);
  const float true_area = difference_of_products(d1x, d2y, d2x, d1y);
  const float inverse_area = true_area == 0.0f ? 0.0f : 1.0f / true_area;
  const float dx = difference_of_products(d2y, depth1, d1y, depth2) * inverse_area,
              dy = difference_of_products(d1x, depth2, d2x, depth1) * inverse_area;
  for (int i = 0; i < 3; ++i) {
    const float change = std::fma(dx, in_subpixels(-corners[i]->rest_x), dy * in_subpixels(-corners[i]->rest_y));
    const TwoFloat at_subpixel =
        at_corner[i] + TwoFloat{std::clamp(change, -layout::max_normalized_depth, layout::max_normalized_depth), 0.0f};
    over_area_[i] = at_subpixel / from_integer(area);
  }
}

TwoFloat NormalizedDepthPlane::normalized_depth(int x, int y, SampleOffset sample) const {
  const std::int64_t px = pixel_centre(x) + sample.subpixels_x() - a_.x,
                     py = pixel_centre(y) + sample.subpixels_y() - a_.y;
  const std::int64_t part_b = px * d2y_ - py * d2x_, part_c = py * d1x_ - px * d1y_, part_a = area_ - part_b - part_c;
  return from_integer(part_a) * over_area_[0] +
         (from_integer(part_b) * over_area_[1] + from_integer(part_c) * over_area_[2]);
}

StoredDepth NormalizedDepthPlane::stored(const TwoFloat& normalized_depth, bool in_range) const {
  const std::uint32_t key = std::min(std::max(key_of(normalized_depth, plan_.depth_format), min_), max_);
  return {decoded_depth(key, plan_), key, in_range};
}

StoredDepth NormalizedDepthPlane::at_centre(int x, int y) const {
  TwoFloat depth = normalized_depth(x, y, {0, 0});
  const bool in_range = in_range_ || depth.high >= 0.0f;
  const float depth1 = over_area_[1].high - over_area_[0].high, depth2 = over_area_[2].high - over_area_[0].high;
  const auto d1x = static_cast<float>(d1x_), d1y = static_cast<float>(d1y_), d2x = static_cast<float>(d2x_),
             d2y = static_cast<float>(d2y_);
  if (const auto change = mirror_images_.change_at(x, y, difference_of_products(d2y, depth1, d1y, depth2),
                                                   difference_of_products(d1x, depth2, d2x, depth1)))
    depth = depth + TwoFloat{*change, 0.0f};
  return stored(depth, in_range);
}

StoredDepth NormalizedDepthPlane::at_sample(int x, int y, SampleOffset sample) const {
  const TwoFloat depth = normalized_depth(x, y, sample);
  return stored(depth, in_range_ || depth.high >= 0.0f);
}

LineDepth::LineDepth(const FramePlan& plan, const ScreenVertex& a, const ScreenVertex& b, bool steep)
    : plan_(plan), run_(steep ? b.y - a.y : b.x - a.x), at_start_{}, at_end_{} {
  const float length = in_subpixels(steep ? b.corner_y() - a.corner_y() : b.corner_x() - a.corner_x());
  const float to_start = in_subpixels(steep ? -a.rest_y : -a.rest_x),
              to_end = in_subpixels(steep ? -b.rest_y : -b.rest_x);
  if (!is_forward(plan.depth_format)) {
    const float slope_along = length > 0.0f ? (b.depth - a.depth) / length : 0.0f;
    start_ = std::fma(slope_along, to_start, a.depth);
    change_ = slope_along * static_cast<float>(run_);
    farthest_ = std::min(a.depth, b.depth);
    nearest_ = std::max(a.depth, b.depth);
    return;
  }
  const TwoFloat at_a = normalized_depth_of(a.depth, plan), at_b = normalized_depth_of(b.depth, plan);
  const float slope_along = length > 0.0f ? rounded_difference(at_b, at_a) / length : 0.0f;
  at_start_ = at_a + TwoFloat{slope_along * to_start, 0.0f};
  at_end_ = at_b + TwoFloat{slope_along * to_end, 0.0f};
  const std::uint32_t key_a = key_of(at_a, plan.depth_format), key_b = key_of(at_b, plan.depth_format);
  min_ = std::min(key_a, key_b);
  max_ = std::max(key_a, key_b);
}

StoredDepth LineDepth::at(std::int64_t offset) const {
  if (!is_forward(plan_.depth_format)) {
    const float depth = std::fma(static_cast<float>(offset) / static_cast<float>(run_), change_, start_);
    return {std::min(std::max(depth, farthest_), nearest_)};
  }
  const TwoFloat normalized_depth =
      (at_start_ * from_integer(run_ - offset) + at_end_ * from_integer(offset)) / from_integer(run_);
  const std::uint32_t key = std::min(std::max(key_of(normalized_depth, plan_.depth_format), min_), max_);
  return {decoded_depth(key, plan_), key, normalized_depth.high >= 0.0f};
}

float LineDepth::slope() const { return change_ * static_cast<float>(layout::subpixels) / static_cast<float>(run_); }

}  // namespace morphcl::reference
