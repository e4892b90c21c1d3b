// Flat convex polygons with integer corners, seen from z = +infinity: what the hidden-surface algorithms below work on.
// Every decision is exact.
//
// Units are half pixels: the centre of pixel (i, j) is (2i + 1, 2j + 1), so that corners may lie on it or beside it. x
// runs to the right, y upwards: row 0 of a picture has the smallest y. Coordinates end at 512, so at most 256 x 256
// pixels show anything.
// Larger z is nearer. A pixel belongs to a polygon that its centre lies in, with the edges towards smaller x and
// smaller y included and the others not, so that two polygons that share an edge never share a pixel. Of equal depths
// the polygon with the lower index is seen.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#pragma GCC visibility push(default)
namespace morphcl {

constexpr int max_polygon_coordinate = 512;  // half pixels

// x X + y Y + z Z - d, positive on the side that the normal points to.
struct IntegerPlane {
  std::int64_t x = 0, y = 0, z = 0, d = 0;
};

// Made by make_flat_polygon(); what uses it does not test it.
struct FlatPolygon {
  std::vector<glm::ivec3> corners;  // counter-clockwise seen from the tip of the plane's normal
  IntegerPlane plane;               // |normal| <= 2^23 a component, |d| <= 2^34
};

// Error(usage) naming what is wrong: fewer than 3 corners, a coordinate out of range, corners that are not all in one
// plane, or not convex, or have no area.
FlatPolygon make_flat_polygon(std::vector<glm::ivec3> corners);

// Whether the pixel belongs to the polygon; never to one that is seen edge-on.
bool covers(const FlatPolygon& polygon, int column, int row);

// -1, 0, 1: a is farther than, as far as, nearer than b at the pixel's centre. Neither is seen edge-on.
int compare_depth(const FlatPolygon& a, const FlatPolygon& b, int column, int row);

// Which polygon each pixel shows, row by row; nothing: -1.
struct PolygonPicture {
  int width = 0, height = 0;
  std::vector<int> polygon;

  PolygonPicture(int picture_width, int picture_height);
  int& at(int column, int row) { return polygon[index(column, row)]; }
  int at(int column, int row) const { return polygon[index(column, row)]; }

 private:
  std::size_t index(int column, int row) const { return static_cast<std::size_t>(std::int64_t{row} * width + column); }
};

// Whether `challenger` is seen before `holder` (-1: nothing), both by index.
bool is_seen_before(const std::vector<FlatPolygon>& polygons, int challenger, int holder, int column, int row);

// ---- hidden surfaces ------------------------------------------------------------------------------------------------
//
// Four ways to the same picture: the one that a z-buffer gives, pixel for pixel. They are the code that draws frames
// (visibility.hpp), here with exact depths.

// Painter's algorithm (Newell, Newell and Sancha 1972): from back to front; what overlaps in a circle or cuts each
// other is split. Error(bad_input) where that needs more than max_visibility_pieces (visibility.hpp).
PolygonPicture painted_picture(const std::vector<FlatPolygon>& polygons, int width, int height);

// The order of a BSP tree (Fuchs, Kedem and Naylor 1980). Errors as those of painted_picture().
PolygonPicture bsp_picture(const std::vector<FlatPolygon>& polygons, int width, int height);

// Warnock (1969): a square window of 2^k pixels is divided in four until one polygon hides all others in it, or none is
// left, or one alone, or it is one pixel. Windows are half-open and whole pixels, so they never lose or share one.
PolygonPicture warnock_picture(const std::vector<FlatPolygon>& polygons, int width, int height);

// Watkins (1970): line by line; between the ends of the polygons' spans the nearest at both ends is the nearest in
// between, and where they differ the interval is halved. Spans are found from the edges anew on each line: nothing is
// added up.
PolygonPicture watkins_picture(const std::vector<FlatPolygon>& polygons, int width, int height);

}  // namespace morphcl
#pragma GCC visibility pop
