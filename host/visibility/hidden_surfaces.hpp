// Four ways to the same picture of flat polygons seen from z = +infinity. Pixel for pixel they agree with a z-buffer.
#pragma once

#include "host/visibility/flat_polygon.hpp"

namespace morphcl {

// Painter's algorithm: back to front by a BSP tree, which splits what has no order. Error(usage) as BspTree.
PolygonPicture painted_picture(const std::vector<FlatPolygon>& polygons, int width, int height);

// Warnock (1969): a square window of 2^k pixels is divided in four until one polygon hides all others in it, or none is
// left, or it is one pixel. Windows are half-open and whole pixels, so they never lose or share one.
PolygonPicture warnock_picture(const std::vector<FlatPolygon>& polygons, int width, int height);

// Watkins (1970): line by line; between the ends of the polygons' spans the nearest at both ends is the nearest in
// between, and where they differ the interval is halved. Spans are found from the edges anew on each line: nothing is
// added up.
PolygonPicture watkins_picture(const std::vector<FlatPolygon>& polygons, int width, int height);

}  // namespace morphcl
