// A clipped line on the screen: one pixel in every column that it crosses (in every row where it is steep), the one
// that holds the line at the column's centre. The end that the line walks towards is not drawn.
#pragma once

#include <algorithm>
#include <cmath>

#include "lab/frame_error/screen_triangle.hpp"

namespace morphcl::accuracy {

template <class Geometry>
class ScreenLine {
 public:
  using Real = typename Geometry::Real;
  using Coordinate = typename Geometry::Coordinate;

  ScreenLine(const Corner<Real>& from, const Corner<Real>& to, const PreciseCamera<Real>& camera)
      : a_(from), b_(to), width_(camera.width), height_(camera.height) {
    ScreenPoint<Coordinate> a = to_screen<Geometry>(a_, width_, height_), b = to_screen<Geometry>(b_, width_, height_);
    const Coordinate wide = b.x < a.x ? Coordinate(a.x - b.x) : Coordinate(b.x - a.x);
    const Coordinate high = b.y < a.y ? Coordinate(a.y - b.y) : Coordinate(b.y - a.y);
    steep_ = high > wide;
    if (steep_ ? b.y < a.y : b.x < a.x) {
      std::swap(a, b);
      std::swap(a_, b_);
    }
    start_ = steep_ ? a.y : a.x;
    run_ = steep_ ? high : wide;
    across_ = steep_ ? a.x : a.y;
    rise_ = steep_ ? Coordinate(b.x - a.x) : Coordinate(b.y - a.y);
    const ScreenPoint<Real> from_end = corner_of_plane<Geometry>(a_, width_, height_),
                            to_end = corner_of_plane<Geometry>(b_, width_, height_);
    exact_start_ = steep_ ? from_end.y : from_end.x;
    exact_run_ = (steep_ ? to_end.y : to_end.x) - exact_start_;
  }

  std::optional<Hit<Real>> hit(int x, int y) const {
    const int along = steep_ ? y : x;
    if (!crosses(along) || pixel_across(along) != (steep_ ? x : y)) return std::nullopt;
    Real second(0);
    if (exact_run_ > 0) second = std::clamp(Real((pixel_centre(along) - exact_start_) / exact_run_), Real(0), Real(1));
    const Real share_a = (1 - second) / a_.w, share_b = second / b_.w, total = share_a + share_b;
    return Hit<Real>{(share_a * a_.distance + share_b * b_.distance) / total, {}, true};
  }

  bool covers_around(int, int, const Coordinate&) const { return false; }  // a line has no inside

  template <class Visit>
  void for_each_pixel(const Visit& visit) const {
    const PixelSpan steps = pixels_between(start_, Coordinate(start_ + run_), steep_ ? height_ : width_);
    for (int along = steps.first; along <= steps.last; ++along) {
      if (!crosses(along)) continue;
      const std::int64_t other = pixel_across(along);
      if (other < 0 || other >= (steep_ ? width_ : height_)) continue;
      const int x = steep_ ? static_cast<int>(other) : along, y = steep_ ? along : static_cast<int>(other);
      visit(x, y, *hit(x, y));
    }
  }

 private:
  Coordinate offset(int along) const { return Coordinate(pixel_centre(along)) - start_; }
  bool crosses(int along) const { return offset(along) >= 0 && offset(along) < run_; }

  // floor((across + rise * offset / run) / sub-pixels of a pixel)
  std::int64_t pixel_across(int along) const {
    const Coordinate numerator = across_ * run_ + rise_ * offset(along), denominator = run_ * layout::subpixels;
    if constexpr (std::is_same_v<Coordinate, std::int64_t>) {
      return numerator / denominator - (numerator % denominator < 0 ? 1 : 0);
    } else {
      using std::floor;
      return static_cast<std::int64_t>(floor(Coordinate(numerator / denominator)));
    }
  }

  Corner<Real> a_, b_;
  int width_, height_;
  bool steep_ = false;
  Coordinate start_, run_, across_, rise_;  // for coverage
  Real exact_start_, exact_run_;            // for distances
};

}  // namespace morphcl::accuracy
