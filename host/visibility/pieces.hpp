// Parts of surfaces, as the painter's algorithm and BSP trees split them.
//
// A piece is its surface, and the sides of the splitters that it lies on. A splitter is a linear function over pixel
// centres; its sign there, one evaluation, decides to which of the two pieces a pixel belongs, so that splitting never
// loses a pixel nor doubles one. A piece's polygon holds all of its pixels and is used to find quickly what cannot
// meet.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "host/visibility/screen_surfaces.hpp"

namespace morphcl::visibility {

// What splits a surface: in front is where the surface is nearer than another one's plane or than a depth, or to the
// right of a line between columns, or below one between rows.
struct Splitter {
  enum class Kind : std::uint8_t { plane, level, column, row };
  Kind kind = Kind::plane;
  SurfaceId plane = no_surface;  // of the surface whose depth plane it is
  int position = 0;              // the first column or row that is in front
  double level = 0;
};

using Polygon = std::vector<glm::dvec2>;  // pixels; centres are whole numbers. Convex, of positive area

struct Piece {
  SurfaceId surface = no_surface;
  std::int32_t side = -1;  // the last of its splitters' sides; -1: the whole surface
  PixelBox box{};
  double min = 0, max = 0;  // of depth
  Polygon polygon;
};

class Pieces {
 public:
  explicit Pieces(const ScreenSurfaces& surfaces) : surfaces_(surfaces) {}

  const ScreenSurfaces& surfaces() const { return surfaces_; }
  Piece whole(SurfaceId surface) const;

  // The function whose sign tells on which side of the splitter a pixel of the surface is; 0 is in front.
  DepthPlane function_of(const Splitter& splitter, SurfaceId surface) const;

  // Which sides the piece has pixel centres on, those nearer to the splitter than `slack` not counted. Neither: it lies
  // in the splitter, or has no pixels.
  struct Sides {
    bool front = false, back = false;
  };
  Sides sides_of(const Piece& piece, const DepthPlane& function, double slack) const;

  // The pieces in front and behind.
  std::pair<Piece, Piece> split(const Piece& piece, const Splitter& splitter);

  // The functions and sides that bound a piece, to be evaluated at many pixels.
  struct Bounds {
    struct Side {
      DepthPlane function;
      bool front;

      bool holds(int x, int y) const { return (function.at(x, y) >= 0) == front; }
      void shorten(Span& span, int y) const;  // to what of a row is on this side
    };
    std::vector<Side> sides;
  };
  Bounds bounds_of(const Piece& piece) const;

  // The piece's pixels of a row.
  Span columns_of(const Piece& piece, const Bounds& bounds, int y) const;

 private:
  struct Side {
    Splitter splitter;
    bool front;
    std::int32_t before;  // the side that the piece had before it was split here
  };
  Piece part(const Piece& piece, const Splitter& splitter, const DepthPlane& function, bool front);

  const ScreenSurfaces& surfaces_;
  std::vector<Side> sides_;
};

// What of the polygon is where function >= -slack.
Polygon clipped(const Polygon& polygon, const DepthPlane& function, double slack);

// What two convex polygons have in common.
Polygon intersection(const Polygon& a, const Polygon& b);

struct Range {
  double min, max;
};
Range range_over(const Polygon& polygon, const DepthPlane& function);

// The pixels of `within` that may lie in the polygon.
PixelBox box_of(const Polygon& polygon, const PixelBox& within);

}  // namespace morphcl::visibility
