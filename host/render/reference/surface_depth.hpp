// The depth that the reference's z-buffer stores at a pixel of a triangle, one pixel at a time; and the plane that it
// rounds, with a bound of its error.
#pragma once

#include <variant>

#include "host/render/reference/depth_plane.hpp"
#include "host/visibility/screen_surfaces.hpp"

namespace morphcl::reference {

class SurfaceDepth {
 public:
  // A triangle whose doubled area on the grid of sub-pixels is positive. `whole`: not clipped.
  SurfaceDepth(const FramePlan& plan, const ScreenVertex& a, const ScreenVertex& b, const ScreenVertex& c,
               std::int64_t area, bool whole);

  StoredDepth at(int x, int y) const;

 private:
  struct Reversed {
    ReversedPlane plane;
    int a_x, a_y;  // of the plane's first corner, sub-pixels
    bool small;
    int first_x, first_y;
  };
  using Plane = std::variant<Reversed, NormalizedDepthPlane>;
  static Plane make(const FramePlan& plan, ScreenVertex a, ScreenVertex b, ScreenVertex c, std::int64_t area,
                    bool whole);

  Plane plane_;
};

// Sets depth, error, min, max and cut_by_far of the surface, whose corners are these; its box holds what it covers.
//
// The error bound is derived for both kinds of depth buffer, with u = 2^-24:
//  - A pixel that the grid has in the triangle is up to R = sqrt(2) / 512 pixel outside of its true corners. There
//  depth
//    is that of a mirror image, within the corners' depths: off the plane by up to 4 R |gradient|.
//  - The gradient has the roundings of two products of differences over an area: 8 u (G + k |gradient|), G being the
//    products' magnitudes over the area and k those of the area's own products over it. Reversed depth carries that
//    over the triangle's extent, twice at most, and adds 8 u of all magnitudes.
//  - Forward depth carries it over the rest to the sub-pixel alone, and adds 2^-42 of the largest magnitude and the
//    rounding to the format: 3/4 of a step, or 2^-24.
// Whatever it is, stored depth stays between the corners': where the bound says less than that, the plane is level.
void set_depth(const FramePlan& plan, const ScreenVertex& a, const ScreenVertex& b, const ScreenVertex& c,
               visibility::Surface& surface);

}  // namespace morphcl::reference
