#include <algorithm>

#include "host/visibility/bsp_tree.hpp"
#include "host/visibility/wide_integer.hpp"
#include "morphcl/hidden_surfaces.hpp"

namespace morphcl {

namespace {

// Whether the polygon's point at the pixel's centre is on the side of the plane. The plane's distance of the point
// times the polygon's normal z is an integer.
bool is_on_side(const PlaneSide& side, const IntegerPlane& polygon, int column, int row) {
  const Int128 x = 2 * column + 1, y = 2 * row + 1;
  const Int128 z = polygon.d - polygon.x * x - polygon.y * y;  // times polygon.z
  const IntegerPlane& plane = side.plane;
  const Int128 distance = (plane.x * x + plane.y * y - plane.d) * polygon.z + plane.z * z;
  const bool in_front = polygon.z > 0 ? distance >= 0 : distance <= 0;
  return in_front == side.front;
}

struct PixelBox {
  int left, right, bottom, top;  // half-open
};

PixelBox pixel_box(const FlatPolygon& polygon, int width, int height) {
  int low[2] = {max_polygon_coordinate, max_polygon_coordinate}, high[2] = {-low[0], -low[1]};
  for (const glm::ivec3& corner : polygon.corners)
    for (int i = 0; i < 2; ++i) {
      low[i] = std::min(low[i], corner[i]);
      high[i] = std::max(high[i], corner[i]);
    }
  return {std::max(low[0] / 2 - 1, 0), std::min(high[0] / 2 + 1, width), std::max(low[1] / 2 - 1, 0),
          std::min(high[1] / 2 + 1, height)};
}

}  // namespace

PolygonPicture painted_picture(const std::vector<FlatPolygon>& polygons, int width, int height) {
  PolygonPicture picture(width, height);
  for (const PolygonPart& part : BspTree(polygons).back_to_front({0, 0, 1, 0})) {
    const FlatPolygon& polygon = polygons[static_cast<std::size_t>(part.polygon)];
    const PixelBox box = pixel_box(polygon, width, height);
    for (int row = box.bottom; row < box.top; ++row)
      for (int column = box.left; column < box.right; ++column) {
        const auto holds = [&](const PlaneSide& side) { return is_on_side(side, polygon.plane, column, row); };
        if (!covers(polygon, column, row) || !std::all_of(part.sides.begin(), part.sides.end(), holds)) continue;
        int& held = picture.at(column, row);
        // Where two polygons cut each other at the very centre of a pixel, their order is not the tree's.
        const bool as_far =
            held >= 0 && compare_depth(polygon, polygons[static_cast<std::size_t>(held)], column, row) == 0;
        if (!as_far || part.polygon < held) held = part.polygon;
      }
  }
  return picture;
}

}  // namespace morphcl
