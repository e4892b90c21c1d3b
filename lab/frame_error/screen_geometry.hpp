// Where a clip-space corner lands on the screen, in sub-pixels (y downwards): on the grids that the renderers use, or
// left where it truly is. A render on the grids shows what rounding alone changes, a render of the true geometry what
// they cost as well.
#pragma once

#include <cmath>
#include <cstdint>

#include "host/render/frame/raster_grid.hpp"
#include "lab/frame_error/precise_clip.hpp"

namespace morphcl::accuracy {

template <class Coordinate>
struct ScreenPoint {
  Coordinate x, y;
};

// For coverage snapped to nearest, ties to even: |coordinates| stay below 2^24, so edge functions are exact in 64 bits.
// For planes rounded to corner units, and still next to the same sub-pixel.
template <class RealType>
struct OnGrid {
  using Real = RealType;
  using Coordinate = std::int64_t;
  static Coordinate place(const Real& v) {
    using std::floor;
    const Real low = floor(v), part = v - low;
    const auto whole = static_cast<std::int64_t>(low);
    if (part < Real(0.5)) return whole;
    if (part > Real(0.5)) return whole + 1;
    return whole % 2 == 0 ? whole : whole + 1;
  }
  static Real place_of_plane(const Real& v) {
    using std::floor;
    const Real snapped = Real(place(v)), unit = Real(1) / layout::corner_units;
    const Real rest = floor((v - snapped) / unit + Real(0.5)) * unit, max_rest = Real(0.5) - unit;
    return snapped + (rest > max_rest ? max_rest : rest);
  }
};

template <class RealType>
struct TrueGeometry {
  using Real = RealType;
  using Coordinate = Real;
  static Coordinate place(const Real& v) { return v; }
  static Real place_of_plane(const Real& v) { return v; }
};

template <class Real>
ScreenPoint<Real> exact_on_screen(const Corner<Real>& c, int width, int height) {
  const Real half_width = Real(layout::half_pixel) * width, half_height = Real(layout::half_pixel) * height;
  return {c.x / c.w * half_width + half_width, half_height - c.y / c.w * half_height};
}

// For coverage.
template <class Geometry>
ScreenPoint<typename Geometry::Coordinate> to_screen(const Corner<typename Geometry::Real>& c, int width, int height) {
  const auto exact = exact_on_screen(c, width, height);
  return {Geometry::place(exact.x), Geometry::place(exact.y)};
}

// For the planes of depth and attributes.
template <class Geometry>
ScreenPoint<typename Geometry::Real> corner_of_plane(const Corner<typename Geometry::Real>& c, int width, int height) {
  const auto exact = exact_on_screen(c, width, height);
  return {Geometry::place_of_plane(exact.x), Geometry::place_of_plane(exact.y)};
}

// Twice the area of from, to, p; the negated bits when `from` and `to` change places, so that of two triangles at an
// edge exactly one has a point, however it is rounded.
template <class Coordinate>
Coordinate edge_function(const ScreenPoint<Coordinate>& from, const ScreenPoint<Coordinate>& to,
                         const ScreenPoint<Coordinate>& p) {
  const bool turn = to.x < from.x || (to.x == from.x && to.y < from.y);
  const ScreenPoint<Coordinate>&a = turn ? to : from, &b = turn ? from : to;
  const Coordinate value = (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
  return turn ? Coordinate(-value) : value;
}

// Whether a point on the edge belongs to the triangle on the edge's positive side: a top or a left edge.
template <class Coordinate>
bool owns_edge(const ScreenPoint<Coordinate>& from, const ScreenPoint<Coordinate>& to) {
  return to.y < from.y || (to.y == from.y && to.x > from.x);
}

}  // namespace morphcl::accuracy
