// The exact share of a pixel that each surface has: what lies nearest, by the planes of depth that the raster has.
//
// Where two planes meet is a line whose coefficients are sums of products of integers and corner depths, formed
// without rounding for the pixel at hand and then rounded once; so the bound of pixel_cells.hpp holds however flat the
// angle or thin the triangle. Planes that are equal everywhere are told apart by the order of drawing, as in the
// raster.
#pragma once

#include <cmath>
#include <limits>

#include "host/render/frame/raster_grid.hpp"
#include "lab/exact_coverage/exact_sum.hpp"
#include "lab/exact_coverage/pixel_cells.hpp"
#include "lab/exact_coverage/raster_polygon.hpp"

namespace morphcl::accuracy {

// An affine function of the pixel with whole coefficients: a x + b y + c, in doubled sub-pixel areas.
struct WholeLine {
  std::int64_t a, b, c;
};

// Not negative on the side of from -> to where polygons of positive area lie.
inline WholeLine line_through(const SubPixelPoint& from, const SubPixelPoint& to, int x, int y) {
  return {std::int64_t{from.y - to.y} * layout::subpixels, std::int64_t{to.x - from.x} * layout::subpixels,
          doubled_area(from, to, {pixel_centre(x), pixel_centre(y)})};
}

// Depth is the sum of weight times depth, over the area.
struct DepthInPixel {
  std::array<WholeLine, 3> weight;
  std::array<double, 3> depth;
  std::int64_t area;

  static DepthInPixel constant(double depth) { return {{{{0, 0, 1}, {0, 0, 0}, {0, 0, 0}}}, {depth, 0, 0}, 1}; }
  static DepthInPixel of(const RasterPolygon& polygon, int x, int y) {
    const std::array<SubPixelPoint, 3>& p = polygon.plane;
    return {{line_through(p[1], p[2], x, y), line_through(p[2], p[0], x, y), line_through(p[0], p[1], x, y)},
            polygon.depth,
            doubled_area(p[0], p[1], p[2])};
  }
};

// Inside is where `depth` is larger than `other`.
template <class Real>
PixelLine<Real> line_where_nearer(const DepthInPixel& depth, const DepthInPixel& other) {
  const auto coefficient = [&](std::int64_t WholeLine::* of) {
    ExactSum sum;
    for (std::size_t k = 0; k < 3; ++k) {
      sum.add_product(other.area, depth.weight[k].*of, depth.depth[k]);
      sum.add_product(-depth.area, other.weight[k].*of, other.depth[k]);
    }
    return sum.rounded<Real>();
  };
  return {coefficient(&WholeLine::a), coefficient(&WholeLine::b), coefficient(&WholeLine::c)};
}

// What a polygon is in one pixel.
template <class Real>
struct PolygonInPixel {
  const RasterPolygon* polygon;
  DepthInPixel depth;
  double centre, low, high;             // depth: about that of the centre; bounds of what the pixel shows of it
  std::array<PixelLine<Real>, 4> edge;  // those that cross the pixel
  std::size_t edges = 0;
  PixelBox<Real> box;  // of the polygon, also where it is outside of the pixel
};

// False where the polygon has no part in the pixel.
template <class Real>
bool place_in_pixel(const RasterPolygon& polygon, int x, int y, PolygonInPixel<Real>& placed) {
  placed.edges = 0;
  for (int i = 0; i < polygon.corners; ++i) {
    const int next = i + 1 == polygon.corners ? 0 : i + 1;
    const WholeLine line =
        line_through(polygon.corner[static_cast<std::size_t>(i)], polygon.corner[static_cast<std::size_t>(next)], x, y);
    const std::int64_t size = std::abs(line.a) + std::abs(line.b);
    if (2 * line.c <= -size) return false;
    if (2 * line.c < size)
      placed.edge[placed.edges++] = {Real(static_cast<double>(line.a)), Real(static_cast<double>(line.b)),
                                     Real(static_cast<double>(line.c))};
  }
  placed.polygon = &polygon;
  std::array<PixelPoint<Real>, 4> corners{};
  for (std::size_t i = 0; i < static_cast<std::size_t>(polygon.corners); ++i)
    corners[i] = {Real((polygon.corner[i].x - pixel_centre(x)) * (1.0 / layout::subpixels)),
                  Real((polygon.corner[i].y - pixel_centre(y)) * (1.0 / layout::subpixels))};
  placed.box = PixelBox<Real>::around(std::span(corners).first(static_cast<std::size_t>(polygon.corners)));
  placed.depth = DepthInPixel::of(polygon, x, y);
  double centre = 0, across = 0, size = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const WholeLine& w = placed.depth.weight[k];
    const double a = static_cast<double>(w.a), b = static_cast<double>(w.b), c = static_cast<double>(w.c);
    centre += c * polygon.depth[k];
    size += (std::abs(a) + std::abs(b) + std::abs(c)) * std::abs(polygon.depth[k]);
  }
  for (const auto of : {&WholeLine::a, &WholeLine::b}) {
    double slope = 0;
    for (std::size_t k = 0; k < 3; ++k) slope += static_cast<double>(placed.depth.weight[k].*of) * polygon.depth[k];
    across += std::abs(slope) / 2;
  }
  // Some ten roundings of sums whose terms add up to `size`.
  constexpr double roundings = 0x1p-48;
  const double area = static_cast<double>(placed.depth.area), reach = across + roundings * size;
  placed.low = std::max((centre - reach) / area, polygon.min_depth());
  placed.high = std::min((centre + reach) / area, polygon.max_depth());
  placed.centre = std::clamp(centre / area, polygon.min_depth(), polygon.max_depth());
  return true;
}

// A surface: a triangle, or an edge of a wireframe, of one of the plan's draws; or nothing.
struct SurfacePart {
  std::uint32_t draw, primitive;
  CoverageUnits area;
  // How fast the area grows, in pixels for each pixel that the picture moves to the right and downwards.
  double with_x, with_y;
};
constexpr std::uint32_t nothing_drawn = 0xffffffff;

// One pixel after the other, in memory that is used again.
template <class Real>
class PixelCoverage {
 public:
  // A pixel is given up when its polygons have been held against so many cells, which takes some seconds.
  static constexpr std::size_t default_max_visits = std::size_t{1} << 26;

  explicit PixelCoverage(double background_depth, std::size_t max_visits = default_max_visits)
      : background_(background_depth), max_visits_(max_visits) {}

  // Of `polygons` that may reach the pixel. False when it takes too long; then parts() means nothing.
  bool find(std::span<const RasterPolygon* const> polygons, int x, int y) {
    placed_.clear();
    parts_.clear();
    error_bound_ = 0;
    PolygonInPixel<Real> placed;
    for (const RasterPolygon* polygon : polygons)
      if (place_in_pixel(*polygon, x, y, placed)) placed_.push_back(placed);
    // From front to back, so that little is cut that is covered afterwards.
    std::sort(placed_.begin(), placed_.end(), [](const auto& p, const auto& q) {
      return p.centre != q.centre ? p.centre > q.centre : p.polygon->order < q.polygon->order;
    });
    if (placed_.empty() || one_covers_all()) {
      add_whole(placed_.empty() ? nullptr : placed_.front().polygon);
      return true;
    }
    return cut();
  }

  // By draw and primitive, nothing last; areas are positive and add up to whole_pixel.
  std::span<const SurfacePart> parts() const { return parts_; }
  // No area is wrong by more, in pixels.
  double error_bound() const { return error_bound_; }

 private:
  bool one_covers_all() const {
    const PolygonInPixel<Real>& first = placed_.front();
    return first.edges == 0 && first.low >= background_ &&
           std::all_of(placed_.begin() + 1, placed_.end(), [&](const auto& other) { return other.high < first.low; });
  }

  void add_whole(const RasterPolygon* polygon) {
    parts_.push_back({polygon ? polygon->draw : nothing_drawn, polygon ? polygon->primitive : 0, whole_pixel, 0, 0});
  }

  bool cut() {
    const DepthInPixel behind_all = DepthInPixel::constant(background_);
    cells_.start();
    std::size_t visits = 0;
    double farthest = background_;  // of all that is seen; known as long as nothing changes
    bool known = true;
    for (std::size_t i = 0; i < placed_.size(); ++i) {
      const PolygonInPixel<Real>& p = placed_[i];
      if (!known) farthest = farthest_seen();
      known = true;
      if (p.high < farthest) continue;
      visits += cells_.cells().size();
      if (visits > max_visits_) return false;
      known =
          !cells_.cover(static_cast<int>(i), p.box, std::span(p.edge).first(p.edges), [&](int other) -> Nearness<Real> {
            if (other == PixelCells<Real>::nothing) {
              if (p.low >= background_) return {Nearness<Real>::in_front, {}};
              if (p.high < background_) return {Nearness<Real>::behind, {}};
              return nearness(line_where_nearer<Real>(p.depth, behind_all), true);
            }
            const PolygonInPixel<Real>& q = placed_[static_cast<std::size_t>(other)];
            if (p.low > q.high) return {Nearness<Real>::in_front, {}};
            if (p.high < q.low) return {Nearness<Real>::behind, {}};
            return nearness(line_where_nearer<Real>(p.depth, q.depth), p.polygon->order < q.polygon->order);
          });
    }
    error_bound_ = cells_.error_bound();
    add_up();
    return true;
  }

  double farthest_seen() const {
    double farthest = std::numeric_limits<double>::infinity();
    for (const auto& cell : cells_.cells())
      farthest = std::min(farthest, cell.surface == PixelCells<Real>::nothing
                                        ? background_
                                        : placed_[static_cast<std::size_t>(cell.surface)].low);
    return farthest;
  }

  static Nearness<Real> nearness(const PixelLine<Real>& line, bool first_of_equals) {
    if (line.a != 0 || line.b != 0) return {Nearness<Real>::along_line, line};
    const bool in_front = line.c != 0 ? line.c > 0 : first_of_equals;
    return {in_front ? Nearness<Real>::in_front : Nearness<Real>::behind, {}};
  }

  void add_up() {
    for (const auto& cell : cells_.cells()) {
      const RasterPolygon* const polygon =
          cell.surface == PixelCells<Real>::nothing ? nullptr : placed_[static_cast<std::size_t>(cell.surface)].polygon;
      SurfacePart part{polygon ? polygon->draw : nothing_drawn, polygon ? polygon->primitive : 0, cell.area, 0, 0};
      // What comes in over one side of the pixel less what leaves over the other one.
      for (std::size_t i = 0; i < cell.polygon.size(); ++i) {
        const auto &p = cell.polygon[i], &q = cell.polygon[i + 1 == cell.polygon.size() ? 0 : i + 1];
        if (p.x == q.x && (p.x == Real(-0.5) || p.x == Real(0.5))) part.with_x += static_cast<double>(p.y - q.y);
        if (p.y == q.y && (p.y == Real(-0.5) || p.y == Real(0.5))) part.with_y += static_cast<double>(q.x - p.x);
      }
      parts_.push_back(part);
    }
    std::sort(parts_.begin(), parts_.end(), [](const SurfacePart& p, const SurfacePart& q) {
      return std::pair(p.draw, p.primitive) < std::pair(q.draw, q.primitive);
    });
    std::size_t kept = 0;
    for (const SurfacePart& part : parts_) {
      if (kept > 0 && parts_[kept - 1].draw == part.draw && parts_[kept - 1].primitive == part.primitive) {
        parts_[kept - 1].area += part.area;
        parts_[kept - 1].with_x += part.with_x;
        parts_[kept - 1].with_y += part.with_y;
      } else {
        parts_[kept++] = part;
      }
    }
    parts_.resize(kept);
  }

  double background_;
  std::size_t max_visits_;
  std::vector<PolygonInPixel<Real>> placed_;
  PixelCells<Real> cells_;
  std::vector<SurfacePart> parts_;
  double error_bound_ = 0;
};

}  // namespace morphcl::accuracy
