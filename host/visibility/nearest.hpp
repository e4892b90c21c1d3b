// Which of some opaque surfaces a pixel shows.
#pragma once

#include <cmath>

#include "host/visibility/shown_rows.hpp"

namespace morphcl::visibility {

// Surfaces that are further apart than their errors are compared by their planes, others by the stored depths.
class NearestAtPixel {
 public:
  NearestAtPixel(const ScreenSurfaces& surfaces, int x, int y) : surfaces_(surfaces), x_(x), y_(y) {}

  // A surface that covers the pixel.
  void add(SurfaceId id) {
    const Surface& surface = surfaces_[id];
    if (surface.cut_by_far && !surfaces_.stored->shows(id, x_, y_)) return;
    const double depth = surface.depth.at(x_, y_);
    if (by_planes_ == no_surface || depth > plane_depth_) {
      by_planes_ = id;
      plane_depth_ = depth;
    }
    if (nearest_ != no_surface) {
      ++comparisons_;
      const double difference = depth - depth_;
      if (std::abs(difference) > surface.error + surfaces_[nearest_].error ? difference < 0 : !stored_in_front(id))
        return;
    }
    nearest_ = id;
    depth_ = depth;
  }

  void show(ShownRows& shown) const {
    if (nearest_ == no_surface) return;
    const std::size_t pixel = shown.index(x_, y_);
    shown.opaque[pixel] = nearest_;
    if (by_planes_ != nearest_) shown.within_error.push_back({pixel, nearest_, by_planes_});
  }

  SurfaceId nearest() const { return nearest_; }
  std::uint64_t comparisons() const { return comparisons_; }

 private:
  bool stored_in_front(SurfaceId id) const { return surfaces_.stored->is_in_front(id, nearest_, x_, y_); }

  const ScreenSurfaces& surfaces_;
  int x_, y_;
  SurfaceId nearest_ = no_surface, by_planes_ = no_surface;
  double depth_ = 0, plane_depth_ = 0;
  std::uint64_t comparisons_ = 0;
};

}  // namespace morphcl::visibility
