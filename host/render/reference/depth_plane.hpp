// The reference's view of kernels/reversed_depth.h and of the other half of kernels/forward_depth.h: depth over a
// triangle and along a line.
#pragma once

#include <algorithm>

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

// The reversed float buffer: from corner a to the centre of an origin pixel, from there in steps of pixels and parts of
// them.
class ReversedPlane {
 public:
  ReversedPlane(const ScreenVertex& a, const ScreenVertex& b, const ScreenVertex& c, std::int64_t area);
  StoredDepth at(int x, int y, SampleOffset sample, int origin_x, int origin_y) const;
  // By way of the centre of its pixel.
  StoredDepth beside_centre(int x, int y, SampleOffset sample, int origin_x, int origin_y) const;

 private:
  ScreenVertex a_;
  int d1x_, d1y_, d2x_, d2y_;
  float d1_, d2_, inverse_area_, dx_, dy_;
};

// Forward buffers: by the exact areas opposite to the corners.
class NormalizedDepthPlane {
 public:
  NormalizedDepthPlane(const FramePlan& plan, const ScreenVertex& a, const ScreenVertex& b, const ScreenVertex& c,
                       std::int64_t area);
  StoredDepth at(int x, int y, SampleOffset sample) const;

 private:
  const FramePlan& plan_;
  ScreenVertex a_;
  int d1x_, d1y_, d2x_, d2y_;
  std::int64_t area_;
  TwoFloat over_area_[3];  // normalized depth of the corners
  std::uint32_t min_, max_;
  bool in_range_;
};

// After offset / run of the line from a to b.
StoredDepth depth_on_line(const FramePlan& plan, const ScreenVertex& a, const ScreenVertex& b, std::int64_t offset,
                          std::int64_t run);

}  // namespace morphcl::reference
