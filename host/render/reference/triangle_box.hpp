// What pixels a triangle may cover, and from where the reference measures depth in it.
#pragma once

#include <algorithm>

#include "host/render/frame/frame_plan.hpp"
#include "host/render/frame/kernel_layout.hpp"
#include "host/render/frame/scene_vertices.hpp"

namespace morphcl::reference {

struct TriangleBox {
  int low_x, high_x, low_y, high_y;  // sub-pixels
  // Pixels that may have a sample in the triangle. The first may lie before the picture, the last not behind it.
  int first_x, first_y, last_x, last_y;

  // Samples lie from min_sample to max_sample sub-pixels from the pixel's upper left.
  TriangleBox(const FramePlan& plan, const ScreenVertex& a, const ScreenVertex& b, const ScreenVertex& c,
              int min_sample = layout::half_pixel, int max_sample = layout::half_pixel)
      : low_x(std::min({a.x, b.x, c.x})),
        high_x(std::max({a.x, b.x, c.x})),
        low_y(std::min({a.y, b.y, c.y})),
        high_y(std::max({a.y, b.y, c.y})),
        first_x(first_pixel(low_x, max_sample)),
        first_y(first_pixel(low_y, max_sample)),
        last_x(std::min(last_pixel(high_x, min_sample), plan.width - 1)),
        last_y(std::min(last_pixel(high_y, min_sample), plan.height - 1)) {}

  static int first_pixel(int low, int max_sample) {
    return (low + layout::subpixels - 1 - max_sample) >> layout::subpixel_bits;
  }
  static int last_pixel(int high, int min_sample) { return (high - min_sample) >> layout::subpixel_bits; }

  // Small triangles measure depth from their own box, to samples by way of the pixel's centre; the others from the
  // tile's pixel that is next to the farthest vertex.
  bool is_small() const {
    const int max_extent = layout::tile * layout::subpixels;
    return high_x - low_x < max_extent && high_y - low_y < max_extent && last_x - first_x < layout::small_pixels &&
           last_y - first_y < layout::small_pixels;
  }
};

inline void turn_farthest_first(ScreenVertex& a, ScreenVertex& b, ScreenVertex& c) {
  const ScreenVertex first = a, second = b, third = c;
  if (b.depth < a.depth && b.depth <= c.depth) {
    a = second;
    b = third;
    c = first;
  } else if (c.depth < a.depth && c.depth < b.depth) {
    a = third;
    b = first;
    c = second;
  }
}

// Of a triangle that is not small, along one axis: the pixel of a pixel's tile that is next to a corner's sub-pixel.
inline int origin_in_tile(int corner, int pixel) {
  const int tile = pixel / layout::tile * layout::tile;
  return std::clamp(corner >> layout::subpixel_bits, tile, tile + layout::tile - 1);
}

}  // namespace morphcl::reference
