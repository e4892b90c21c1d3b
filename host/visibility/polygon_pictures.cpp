// Pictures of flat polygons with integer corners, by the algorithms that draw frames; here every decision is exact.
#include <algorithm>
#include <cmath>
#include <utility>

#include "host/visibility/area_subdivision.hpp"
#include "host/visibility/bsp.hpp"
#include "host/visibility/depth_sort.hpp"
#include "host/visibility/paint.hpp"
#include "host/visibility/scan_line.hpp"
#include "morphcl/hidden_surfaces.hpp"
#include "morphcl/visibility.hpp"

namespace morphcl {

namespace {

using visibility::ShownRows;
using visibility::Surface;
using visibility::SurfaceId;

// The triangles of the polygons, with exact depths.
class PolygonSurfaces : private visibility::StoredDepths {
 public:
  PolygonSurfaces(const std::vector<FlatPolygon>& polygons, int width, int height) : polygons_(polygons) {
    surfaces_.width = width;
    surfaces_.height = height;
    surfaces_.stored = this;
    for (std::size_t i = 0; i < polygons.size(); ++i)
      for (std::size_t k = 2; k < polygons[i].corners.size(); ++k) add(i, k);
  }
  PolygonSurfaces(const PolygonSurfaces&) = delete;
  PolygonSurfaces& operator=(const PolygonSurfaces&) = delete;

  const visibility::ScreenSurfaces& surfaces() const { return surfaces_; }

  PolygonPicture picture_of(const ShownRows& shown) const {
    PolygonPicture picture(surfaces_.width, surfaces_.height);
    for (std::size_t i = 0; i < shown.opaque.size(); ++i)
      if (shown.opaque[i] != visibility::no_surface) picture.polygon[i] = static_cast<int>(polygon_[shown.opaque[i]]);
    return picture;
  }

 private:
  // The triangle of a polygon's first corner and the k-th with the one before.
  void add(std::size_t index, std::size_t k) {
    const FlatPolygon& polygon = polygons_[index];
    const IntegerPlane& plane = polygon.plane;
    if (plane.z == 0) return;
    constexpr int half_pixel = visibility::subpixels / 2;
    glm::ivec2 a = polygon.corners[0] * half_pixel, b = polygon.corners[k - 1] * half_pixel,
               c = polygon.corners[k] * half_pixel;
    if (plane.z < 0) std::swap(b, c);
    if (std::int64_t{b.x - a.x} * (c.y - a.y) == std::int64_t{c.x - a.x} * (b.y - a.y)) return;
    Surface surface;
    surface.corner = {a, b, c};
    const auto [low_x, high_x] = std::minmax({a.x, b.x, c.x});
    const auto [low_y, high_y] = std::minmax({a.y, b.y, c.y});
    const auto first = [](int low) { return std::max((low + half_pixel - 1) >> 8, 0); };
    const auto last = [](int high, int size) { return std::min((high - half_pixel) >> 8, size - 1); };
    surface.box = {first(low_x), first(low_y), last(high_x, surfaces_.width), last(high_y, surfaces_.height)};
    if (surface.box.empty()) return;
    // In half pixels the centre of pixel (x, y) is (2 x + 1, 2 y + 1).
    const auto z = static_cast<double>(plane.z), of_x = static_cast<double>(plane.x) / z,
               of_y = static_cast<double>(plane.y) / z;
    surface.depth = {static_cast<double>(plane.d) / z - of_x - of_y, -2 * of_x, -2 * of_y};
    // Of eight roundings: planes and their differences are within it, and what is closer is compared in integers.
    surface.error = 0x1p-50 * (std::abs(surface.depth.at_origin) +
                               2 * max_polygon_coordinate * (std::abs(of_x) + std::abs(of_y)) + max_polygon_coordinate);
    const auto [farthest, nearest] =
        std::minmax({polygon.corners[0].z, polygon.corners[k - 1].z, polygon.corners[k].z});
    surface.min = farthest - surface.error;
    surface.max = nearest + surface.error;
    surfaces_.surfaces.push_back(surface);
    polygon_.push_back(index);
  }

  bool shows(SurfaceId /*surface*/, int /*x*/, int /*y*/) const override { return true; }
  bool is_in_front(SurfaceId a, SurfaceId b, int x, int y) const override {
    const int order = compare_depth(polygons_[polygon_[a]], polygons_[polygon_[b]], x, y);
    return order != 0 ? order > 0 : polygon_[a] < polygon_[b];
  }

  const std::vector<FlatPolygon>& polygons_;
  visibility::ScreenSurfaces surfaces_;
  std::vector<std::size_t> polygon_;  // of each surface
};

}  // namespace

PolygonPicture painted_picture(const std::vector<FlatPolygon>& polygons, int width, int height) {
  const PolygonSurfaces of(polygons, width, height);
  ShownRows shown({}, width, height);
  visibility::Pieces pieces(of.surfaces());
  const visibility::DepthSort sorted = visibility::sort_by_depth(pieces, max_visibility_pieces);
  visibility::paint(pieces, sorted.back_to_front, shown);
  return of.picture_of(shown);
}

PolygonPicture bsp_picture(const std::vector<FlatPolygon>& polygons, int width, int height) {
  const PolygonSurfaces of(polygons, width, height);
  ShownRows shown({}, width, height);
  visibility::Pieces pieces(of.surfaces());
  const visibility::Bsp tree = visibility::build_bsp(pieces, max_visibility_pieces);
  std::vector<visibility::Piece> order;
  for (const std::uint32_t i : tree.back_to_front()) order.push_back(tree.pieces[i]);
  visibility::paint(pieces, order, shown);
  return of.picture_of(shown);
}

PolygonPicture warnock_picture(const std::vector<FlatPolygon>& polygons, int width, int height) {
  const PolygonSurfaces of(polygons, width, height);
  ShownRows shown({}, width, height);
  visibility::subdivide(of.surfaces(), shown);
  return of.picture_of(shown);
}

PolygonPicture watkins_picture(const std::vector<FlatPolygon>& polygons, int width, int height) {
  const PolygonSurfaces of(polygons, width, height);
  ShownRows shown({}, width, height);
  visibility::scan_lines(of.surfaces(), shown);
  return of.picture_of(shown);
}

}  // namespace morphcl
