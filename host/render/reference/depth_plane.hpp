// The reference's view of kernels/reversed_depth.h and of the other half of kernels/forward_depth.h: depth over a
// triangle and along a line.
#pragma once

#include <algorithm>
#include <optional>

#include "host/render/frame/kernel_layout.hpp"
#include "host/render/frame/normalized_depth.hpp"
#include "host/render/frame/raster_grid.hpp"
#include "host/render/frame/sample_pattern.hpp"
#include "host/render/frame/scene_vertices.hpp"

namespace morphcl::reference {

// What a depth buffer holds at a pixel.
struct StoredDepth {
  float depth;            // near / distance, in parallel projections minus the distance: what the buffer stands for
  std::uint32_t key = 0;  // of forward buffers: by this they compare
  bool in_range = true;   // of forward buffers: not beyond the far plane. The reversed one compares with its background
};

// Triangles a b c whose doubled area is positive.

// How depth changes from a place that coverage's grid has in the triangle, but that is outside its corners, to the
// mirror image in the edge that it is beyond.
class MirrorImages {
 public:
  MirrorImages(const ScreenVertex& a, const ScreenVertex& b, const ScreenVertex& c);
  // At a pixel's centre; depth changes by (dx, dy) per sub-pixel. Nothing inside.
  std::optional<float> change_at(int x, int y, float dx, float dy) const;

 private:
  ScreenVertex corner_[3];
  float dx_[3], dy_[3];  // from each to the next, sub-pixels
};

// The reversed float buffer: the plane through the corners where they are, from corner a to the centre of an origin
// pixel, from there in steps of pixels and parts of them; within the corners' own depths.
class ReversedPlane {
 public:
  ReversedPlane(const ScreenVertex& a, const ScreenVertex& b, const ScreenVertex& c);
  StoredDepth at_centre(int x, int y, int origin_x, int origin_y) const;
  StoredDepth at_sample(int x, int y, SampleOffset sample, int origin_x, int origin_y) const;
  // By way of the centre of its pixel, which may be outside the corners.
  StoredDepth at_sample_of_small(int x, int y, SampleOffset sample, int origin_x, int origin_y) const;

 private:
  float on_plane(int x, int y, SampleOffset sample, int origin_x, int origin_y) const;
  float within_corners(float depth) const { return std::min(std::max(depth, min_), max_); }

  ScreenVertex a_;
  float unit_dx_ = 0, unit_dy_ = 0;  // change of depth a corner unit
  float min_, max_;
  MirrorImages mirror_images_;
};

// Forward buffers: by the exact areas opposite to the corners, whose values are taken along the plane to the sub-pixels
// that they are snapped to.
class NormalizedDepthPlane {
 public:
  NormalizedDepthPlane(const FramePlan& plan, const ScreenVertex& a, const ScreenVertex& b, const ScreenVertex& c,
                       std::int64_t area);
  StoredDepth at_centre(int x, int y) const;
  StoredDepth at_sample(int x, int y, SampleOffset sample) const;

 private:
  TwoFloat normalized_depth(int x, int y, SampleOffset sample) const;
  StoredDepth stored(const TwoFloat& normalized_depth, bool in_range) const;

  const FramePlan& plan_;
  ScreenVertex a_;
  int d1x_, d1y_, d2x_, d2y_;
  std::int64_t area_;
  TwoFloat over_area_[3];  // normalized depth of the corners
  std::uint32_t min_, max_;
  bool in_range_;
  MirrorImages mirror_images_;
};

// Along a line, from a to b on its longer axis.
class LineDepth {
 public:
  LineDepth(const FramePlan& plan, const ScreenVertex& a, const ScreenVertex& b, bool steep);
  StoredDepth at(std::int64_t offset) const;  // sub-pixels from where a is snapped to
  float slope() const;                        // of the reversed float buffer, per pixel

 private:
  const FramePlan& plan_;
  std::int64_t run_;
  float start_ = 0, change_ = 0, farthest_ = 0, nearest_ = 0;  // of the reversed float buffer
  TwoFloat at_start_, at_end_;                                 // of forward ones
  std::uint32_t min_ = 0, max_ = 0;
};

}  // namespace morphcl::reference
