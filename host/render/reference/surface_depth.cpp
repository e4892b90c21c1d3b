#include "host/render/reference/surface_depth.hpp"

#include <cmath>
#include <utility>

#include "host/math/unit_roundoff.hpp"
#include "host/render/reference/triangle_box.hpp"
#include "host/visibility/wide_integer.hpp"

namespace morphcl::reference {

namespace {

constexpr double pixel_units = double{layout::corner_units} * layout::subpixels;  // corner units of a pixel

double magnitude_of_products(double a, double b, double c, double d) { return std::abs(a * b) + std::abs(c * d); }

// a b - c d, within 2 roundings of the result (Kahan).
double precise_difference(double a, double b, double c, double d) {
  const double w = c * d;
  return std::fma(a, b, -w) + std::fma(-c, d, w);
}

double rounding_of_format(DepthFormat format) {
  return format == DepthFormat::forward_float ? unit_roundoff<float> : 0.75 / steps_of(format);
}

}  // namespace

SurfaceDepth::Plane SurfaceDepth::make(const FramePlan& plan, ScreenVertex a, ScreenVertex b, ScreenVertex c,
                                       std::int64_t area, bool whole) {
  if (is_forward(plan.depth_format)) return NormalizedDepthPlane(plan, a, b, c, area);
  const TriangleBox box(plan, a, b, c);
  const bool small = whole && box.is_small();
  if (!small) turn_farthest_first(a, b, c);
  return Reversed{ReversedPlane(a, b, c), a.x, a.y, small, box.first_x, box.first_y};
}

SurfaceDepth::SurfaceDepth(const FramePlan& plan, const ScreenVertex& a, const ScreenVertex& b, const ScreenVertex& c,
                           std::int64_t area, bool whole)
    : plane_(make(plan, a, b, c, area, whole)) {}

StoredDepth SurfaceDepth::at(int x, int y) const {
  if (const auto* forward = std::get_if<NormalizedDepthPlane>(&plane_)) return forward->at_centre(x, y);
  const Reversed& of = *std::get_if<Reversed>(&plane_);
  if (of.small) return of.plane.at_centre(x, y, of.first_x, of.first_y);
  return of.plane.at_centre(x, y, origin_in_tile(of.a_x, x), origin_in_tile(of.a_y, y));
}

void set_depth(const FramePlan& plan, const ScreenVertex& a, const ScreenVertex& b, const ScreenVertex& c,
               visibility::Surface& surface) {
  const bool forward = is_forward(plan.depth_format);
  double depth[3];
  const ScreenVertex* const corner[3] = {&a, &b, &c};
  for (int i = 0; i < 3; ++i) {
    depth[i] = corner[i]->depth;
    if (!forward) continue;
    const TwoFloat normalized = normalized_depth_of(corner[i]->depth, plan);
    depth[i] = double{normalized.high} + double{normalized.low};
  }
  const double min = std::min({depth[0], depth[1], depth[2]}), max = std::max({depth[0], depth[1], depth[2]});
  const double magnitude = std::max(std::abs(min), std::abs(max));
  const double of_format = forward ? rounding_of_format(plan.depth_format) + 0x1p-42 * magnitude : 0;
  surface.cut_by_far = min < (forward ? 0.0 : double{plan.camera.far_depth});

  const std::int64_t x1 = b.corner_x() - a.corner_x(), y1 = b.corner_y() - a.corner_y(),
                     x2 = c.corner_x() - a.corner_x(), y2 = c.corner_y() - a.corner_y();
  const auto d1x = static_cast<double>(x1), d1y = static_cast<double>(y1), d2x = static_cast<double>(x2),
             d2y = static_cast<double>(y2);
  const auto area = static_cast<double>(Int128{x1} * y2 - Int128{x2} * y1);
  const double depth1 = depth[1] - depth[0], depth2 = depth[2] - depth[0];
  // A level plane in the middle of the corners' depths.
  surface.depth = {0.5 * (min + max), 0, 0};
  surface.error = 0.5 * (max - min) + of_format;
  if (area != 0) {
    constexpr double u = unit_roundoff<float>;
    const double scale = pixel_units / area, size = std::abs(scale);
    const double dx = precise_difference(d2y, depth1, d1y, depth2) * scale,
                 dy = precise_difference(d1x, depth2, d2x, depth1) * scale;
    const double products_x = magnitude_of_products(d2y, depth1, d1y, depth2) * size,
                 products_y = magnitude_of_products(d1x, depth2, d2x, depth1) * size;
    const double condition = magnitude_of_products(d1x, d2y, d2x, d1y) / std::abs(area);
    const int low_x = std::min({a.x, b.x, c.x}), high_x = std::max({a.x, b.x, c.x}), low_y = std::min({a.y, b.y, c.y}),
              high_y = std::max({a.y, b.y, c.y});
    const double width = static_cast<double>(high_x - low_x) / layout::subpixels + 1,
                 height = static_cast<double>(high_y - low_y) / layout::subpixels + 1;
    const double slope_x = 8 * u * (products_x + condition * std::abs(dx)),
                 slope_y = 8 * u * (products_y + condition * std::abs(dy));
    // The second term: places are rounded to fp32 in mirror images.
    const double outside = std::sqrt(2.0) / (2 * layout::subpixels) + 4 * u * (width + height);
    double error = 4 * outside * (std::abs(dx) + std::abs(dy)) + of_format;
    if (forward)
      error += (slope_x + slope_y) * (2.0 / layout::subpixels);
    else
      error +=
          2 * (slope_x * width + slope_y * height) + 8 * u * (magnitude + std::abs(dx) * width + std::abs(dy) * height);
    if (error < surface.error) {
      const double x = static_cast<double>(a.corner_x()) / pixel_units - 0.5,
                   y = static_cast<double>(a.corner_y()) / pixel_units - 0.5;
      surface.depth = {depth[0] - dx * x - dy * y, dx, dy};
      surface.error = error;
    }
  }
  surface.min = min - of_format;
  surface.max = max + of_format;
}

}  // namespace morphcl::reference
