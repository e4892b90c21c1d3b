#include "lab/exact_coverage/raster_polygon.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "host/render/frame/normalized_depth.hpp"
#include "host/render/reference/screen_primitives.hpp"

namespace morphcl::accuracy {

namespace {

using reference::PrimitiveIdentity;
using reference::ScreenVertex;

class PolygonCollector {
 public:
  PolygonCollector(const FramePlan& plan, std::vector<RasterPolygon>& polygons) : plan_(plan), polygons_(polygons) {}

  void triangle(const reference::ScreenTriangle& t, const PrimitiveIdentity& identity) {
    ScreenVertex b = t.b, c = t.c;
    const std::int64_t area = doubled_area(point(t.a), point(b), point(c));
    if (area == 0 || (area < 0 && !t.double_sided)) return;
    if (area < 0) std::swap(b, c);
    RasterPolygon polygon = polygon_of(identity);
    polygon.corners = 3;
    polygon.plane = {point(t.a), point(b), point(c)};
    polygon.depth = {depth_of(t.a), depth_of(b), depth_of(c)};
    std::copy(polygon.plane.begin(), polygon.plane.end(), polygon.corner.begin());
    keep(polygon);
  }

  void line(const reference::ScreenLine& line, const PrimitiveIdentity& identity) {
    ScreenVertex a = line.from, b = line.to;
    const bool steep = std::abs(b.y - a.y) > std::abs(b.x - a.x);
    if (steep ? b.y < a.y : b.x < a.x) std::swap(a, b);
    const int run = steep ? b.y - a.y : b.x - a.x, rise = steep ? b.x - a.x : b.y - a.y;
    if (run == 0) return;
    const auto half = static_cast<int>(reference::half_thickness(run, rise, line.width));
    const auto beside = [steep](const ScreenVertex& v, int across) -> SubPixelPoint {
      return {steep ? v.x + across : v.x, steep ? v.y : v.y + across};
    };
    RasterPolygon polygon = polygon_of(identity);
    polygon.corners = 4;
    polygon.corner = {beside(a, -half), beside(b, -half), beside(b, half), beside(a, half)};
    // Along the longer axis alone.
    polygon.plane = {point(a), beside(b, -rise), beside(a, run)};
    polygon.depth = {depth_of(a), depth_of(b), depth_of(a)};
    if (steep) {
      std::swap(polygon.corner[1], polygon.corner[3]);
      std::swap(polygon.plane[1], polygon.plane[2]);
      std::swap(polygon.depth[1], polygon.depth[2]);
    }
    keep(polygon);
  }

 private:
  static SubPixelPoint point(const ScreenVertex& v) { return {v.x, v.y}; }

  static RasterPolygon polygon_of(const PrimitiveIdentity& identity) {
    RasterPolygon polygon;
    polygon.order = identity.order;
    polygon.draw = identity.draw;
    polygon.primitive = identity.primitive;
    return polygon;
  }

  double depth_of(const ScreenVertex& v) const {
    if (!is_forward(plan_.depth_format)) return v.depth;
    const reference::TwoFloat normalized = reference::normalized_depth_of(v.depth, plan_);
    return double{normalized.high} + double{normalized.low};
  }

  void keep(const RasterPolygon& polygon) {
    if (!std::all_of(polygon.depth.begin(), polygon.depth.end(), [](double d) { return std::isfinite(d); })) return;
    const auto corners = std::span(polygon.corner).first(static_cast<std::size_t>(polygon.corners));
    const auto reaches = [&](const auto& is_inside) { return std::any_of(corners.begin(), corners.end(), is_inside); };
    if (reaches([](const SubPixelPoint& p) { return p.x > 0; }) &&
        reaches([](const SubPixelPoint& p) { return p.y > 0; }) &&
        reaches([this](const SubPixelPoint& p) { return p.x < plan_.width * layout::subpixels; }) &&
        reaches([this](const SubPixelPoint& p) { return p.y < plan_.height * layout::subpixels; }))
      polygons_.push_back(polygon);
  }

  const FramePlan& plan_;
  std::vector<RasterPolygon>& polygons_;
};

}  // namespace

std::vector<RasterPolygon> raster_polygons(const FramePlan& plan) {
  const RasterGrid grid(plan.width, plan.height);
  std::vector<std::vector<reference::Vertex>> vertices;
  for (const Draw& draw : plan.draws) vertices.push_back(reference::project_vertices(draw, plan, grid));
  std::vector<RasterPolygon> polygons;
  reference::for_each_screen_primitive(plan, grid, vertices, PolygonCollector(plan, polygons));
  return polygons;
}

double background_depth_of(const FramePlan& plan) {
  return is_forward(plan.depth_format) ? 0 : double{plan.camera.far_depth};
}

}  // namespace morphcl::accuracy
