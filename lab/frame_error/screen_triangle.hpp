// A clipped triangle on the screen: which pixel centres it covers, and what it shows there.
#pragma once

#include <algorithm>
#include <array>
#include <optional>

#include "lab/frame_error/screen_geometry.hpp"

namespace morphcl::accuracy {

// What a primitive shows at a pixel's centre.
template <class Real>
struct Hit {
  Real distance;
  std::array<Real, 3> weight;  // of the primitive's vertices, perspective-correct, sum 1
  bool front = true;           // the outside is seen
};

// The first and last pixel whose centre lies between two coordinates, within 0 to size - 1.
struct PixelSpan {
  int first, last;
};
template <class Coordinate>
PixelSpan pixels_between(const Coordinate& low, const Coordinate& high, int size) {
  // Any coordinate of the guard band fits; one pixel more on both sides spares a rounding rule.
  const int first = static_cast<int>(low) / layout::subpixels - 2,
            last = static_cast<int>(high) / layout::subpixels + 2;
  return {std::max(first, 0), std::min(last, size - 1)};
}

template <class Geometry>
class ScreenTriangle {
 public:
  using Real = typename Geometry::Real;
  using Coordinate = typename Geometry::Coordinate;

  // Corners in the order of the mesh; `mirrored`: its front faces turn clockwise.
  ScreenTriangle(const std::array<Corner<Real>, 3>& corners, const PreciseCamera<Real>& camera, bool mirrored)
      : corner_(corners), width_(camera.width), height_(camera.height) {
    for (std::size_t i = 0; i < 3; ++i) {
      at_[i] = to_screen<Geometry>(corners[i], width_, height_);
      plane_[i] = corner_of_plane<Geometry>(corners[i], width_, height_);
    }
    const Coordinate area = edge_function(at_[0], at_[1], at_[2]);
    empty_ = area == 0;
    front_ = (area < 0) != mirrored;  // y points down: counter-clockwise is negative
    if (area > 0) return;
    std::swap(at_[1], at_[2]);
    std::swap(plane_[1], plane_[2]);
    std::swap(corner_[1], corner_[2]);
  }

  bool empty() const { return empty_; }
  bool front() const { return front_; }

  // Nothing where the centre of pixel (x, y) is not covered.
  std::optional<Hit<Real>> hit(int x, int y) const {
    const ScreenPoint<Coordinate> centre{Coordinate(pixel_centre(x)), Coordinate(pixel_centre(y))};
    for (std::size_t i = 0; i < 3; ++i) {
      const ScreenPoint<Coordinate>&from = at_[(i + 1) % 3], &to = at_[(i + 2) % 3];
      const Coordinate value = edge_function(from, to, centre);
      if (owns_edge(from, to) ? value < 0 : value <= 0) return std::nullopt;
    }
    return place({Real(pixel_centre(x)), Real(pixel_centre(y))});
  }

  // Whether everything within `reach` sub-pixels of the pixel's centre, sideways and up and down, is covered.
  bool covers_around(int x, int y, const Coordinate& reach) const {
    const ScreenPoint<Coordinate> centre{Coordinate(pixel_centre(x)), Coordinate(pixel_centre(y))};
    for (std::size_t i = 0; i < 3; ++i) {
      const ScreenPoint<Coordinate>&from = at_[i], &to = at_[(i + 1) % 3];
      const Coordinate wide = to.x < from.x ? Coordinate(from.x - to.x) : Coordinate(to.x - from.x);
      const Coordinate high = to.y < from.y ? Coordinate(from.y - to.y) : Coordinate(to.y - from.y);
      if (edge_function(from, to, centre) <= (wide + high) * reach) return false;
    }
    return true;
  }

  // visit(x, y, hit) for every pixel that is covered.
  template <class Visit>
  void for_each_pixel(const Visit& visit) const {
    const auto [low_x, high_x] = std::minmax({at_[0].x, at_[1].x, at_[2].x});
    const auto [low_y, high_y] = std::minmax({at_[0].y, at_[1].y, at_[2].y});
    const PixelSpan columns = pixels_between(low_x, high_x, width_), rows = pixels_between(low_y, high_y, height_);
    for (int y = rows.first; y <= rows.last; ++y)
      for (int x = columns.first; x <= columns.last; ++x)
        if (const std::optional<Hit<Real>> found = hit(x, y)) visit(x, y, *found);
  }

 private:
  using Areas = std::array<Real, 3>;  // doubled, opposite to the corners; not negative where a point is inside
  Areas areas_at(const ScreenPoint<Real>& p) const {
    Areas area;
    for (std::size_t i = 0; i < 3; ++i) area[i] = edge_function(plane_[(i + 1) % 3], plane_[(i + 2) % 3], p);
    if (area[0] + area[1] + area[2] < 0)
      for (Real& part : area) part = -part;
    return area;
  }

  // Of what is outside the corners, though the snapped triangle covers it: its mirror image in the edge that it is
  // farthest beyond.
  ScreenPoint<Real> mirror_image(const ScreenPoint<Real>& p, const Areas& area) const {
    ScreenPoint<Real> image = p;
    Real farthest(0);
    for (std::size_t i = 0; i < 3; ++i) {
      const ScreenPoint<Real>&from = plane_[(i + 1) % 3], &to = plane_[(i + 2) % 3];
      const Real dx = to.x - from.x, dy = to.y - from.y, square = dx * dx + dy * dy;
      if (!(area[i] < 0) || !(area[i] * area[i] / square > farthest)) continue;
      farthest = area[i] * area[i] / square;
      const Real way = 2 * (dx * (p.y - from.y) - dy * (p.x - from.x)) / square;
      image = {p.x + way * dy, p.y - way * dx};
    }
    return image;
  }

  Real distance(const Areas& area) const {
    Real sum(0), total(0), nearest = corner_[0].distance, farthest = nearest;
    for (std::size_t i = 0; i < 3; ++i) {
      total += area[i] / corner_[i].w;
      sum += area[i] / corner_[i].w * corner_[i].distance;
      nearest = std::min(nearest, corner_[i].distance);
      farthest = std::max(farthest, corner_[i].distance);
    }
    return total > 0 ? std::clamp(Real(sum / total), nearest, farthest) : farthest;
  }

  Hit<Real> place(const ScreenPoint<Real>& p) const {
    Areas area = areas_at(p), inside = area;
    const bool is_inside = std::all_of(area.begin(), area.end(), [](const Real& part) { return part >= 0; });
    if (!is_inside) {
      const bool nowhere = std::all_of(area.begin(), area.end(), [](const Real& part) { return part <= 0; });
      for (Real& part : inside) part = nowhere ? Real(1) : std::max(part, Real(0));
      area = areas_at(mirror_image(p, area));
    }
    Hit<Real> hit{distance(area), {}, front_};
    Real total(0);
    for (std::size_t i = 0; i < 3; ++i) total += inside[i] / corner_[i].w;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < 3; ++k) hit.weight[k] += inside[i] / corner_[i].w / total * corner_[i].weight[k];
    return hit;
  }

  std::array<Corner<Real>, 3> corner_;
  std::array<ScreenPoint<Coordinate>, 3> at_;  // for coverage
  std::array<ScreenPoint<Real>, 3> plane_;
  int width_, height_;
  bool empty_ = false, front_ = true;
};

}  // namespace morphcl::accuracy
