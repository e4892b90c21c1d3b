// Areas of visible surfaces in a pixel by another way, in 113 bits: slabs between all heights at which two lines cross.
// Within a slab no two lines cross, so what a horizontal line sees changes along it only where it meets one of them,
// and the length of a surface on the line in the middle times the slab's height is the surface's area in it.
#pragma once

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <vector>

#include "lab/exact_coverage/raster_polygon.hpp"

namespace morphcl::accuracy::testing {

using Quad = boost::multiprecision::cpp_bin_float_quad;

struct QuadLine {
  Quad a, b, c;
  Quad at(const Quad& x, const Quad& y) const { return a * x + b * y + c; }
};

class SlabCoverage {
 public:
  // Areas of `polygons` in pixel (px, py), in their order; the last one is that of what shows none.
  static std::vector<Quad> areas(const std::vector<RasterPolygon>& polygons, int px, int py) {
    return SlabCoverage(polygons, px, py).areas();
  }

 private:
  struct Shape {
    std::vector<QuadLine> edges;
    QuadLine depth;
    std::uint64_t order;
  };

  SlabCoverage(const std::vector<RasterPolygon>& polygons, int px, int py) {
    const Quad middle_x = Quad(px) + Quad(0.5), middle_y = Quad(py) + Quad(0.5);
    const auto line = [&](const SubPixelPoint& from, const SubPixelPoint& to) -> QuadLine {
      const Quad dx = Quad(to.x) - from.x, dy = Quad(to.y) - from.y;
      return {-dy * 256, dx * 256, dx * (middle_y * 256 - from.y) - dy * (middle_x * 256 - from.x)};
    };
    for (const RasterPolygon& p : polygons) {
      Shape shape;
      shape.order = p.order;
      for (int i = 0; i < p.corners; ++i)
        shape.edges.push_back(
            line(p.corner[static_cast<std::size_t>(i)], p.corner[static_cast<std::size_t>((i + 1) % p.corners)]));
      const QuadLine weight[3] = {line(p.plane[1], p.plane[2]), line(p.plane[2], p.plane[0]),
                                  line(p.plane[0], p.plane[1])};
      const Quad area = weight[0].c + weight[1].c + weight[2].c;
      shape.depth = {0, 0, 0};
      for (std::size_t k = 0; k < 3; ++k) {
        shape.depth.a += weight[k].a * p.depth[k] / area;
        shape.depth.b += weight[k].b * p.depth[k] / area;
        shape.depth.c += weight[k].c * p.depth[k] / area;
      }
      shapes_.push_back(shape);
    }
    for (const Shape& shape : shapes_)
      for (const QuadLine& edge : shape.edges) add(edge);
    for (std::size_t i = 0; i < shapes_.size(); ++i)
      for (std::size_t k = 0; k < i; ++k) {
        const QuadLine &p = shapes_[i].depth, &q = shapes_[k].depth;
        add({p.a - q.a, p.b - q.b, p.c - q.c});
      }
    for (const double side : {-0.5, 0.5}) lines_.push_back({1, 0, -side});
  }

  void add(const QuadLine& line) {
    if (abs(line.c) <= (abs(line.a) + abs(line.b)) / 2) lines_.push_back(line);
  }

  std::vector<Quad> areas() const {
    std::vector<Quad> heights = {Quad(-0.5), Quad(0.5)};
    const auto add_height = [&](const Quad& y) {
      if (y > -0.5 && y < 0.5) heights.push_back(y);
    };
    for (std::size_t i = 0; i < lines_.size(); ++i)
      for (std::size_t k = 0; k < i; ++k) {
        const QuadLine &p = lines_[i], &q = lines_[k];
        const Quad determinant = p.a * q.b - q.a * p.b;
        if (determinant != 0) add_height((q.a * p.c - p.a * q.c) / determinant);
      }
    for (const QuadLine& line : lines_)
      if (line.a == 0 && line.b != 0) add_height(-line.c / line.b);
    std::sort(heights.begin(), heights.end());
    std::vector<Quad> areas(shapes_.size() + 1, Quad(0));
    for (std::size_t i = 1; i < heights.size(); ++i)
      if (heights[i] > heights[i - 1]) add_slab((heights[i] + heights[i - 1]) / 2, heights[i] - heights[i - 1], areas);
    return areas;
  }

  void add_slab(const Quad& y, const Quad& height, std::vector<Quad>& areas) const {
    std::vector<Quad> places = {Quad(-0.5), Quad(0.5)};
    for (const QuadLine& line : lines_) {
      if (line.a == 0) continue;
      const Quad x = -(line.b * y + line.c) / line.a;
      if (x > -0.5 && x < 0.5) places.push_back(x);
    }
    std::sort(places.begin(), places.end());
    for (std::size_t i = 1; i < places.size(); ++i)
      if (places[i] > places[i - 1])
        areas[nearest_at((places[i] + places[i - 1]) / 2, y)] += (places[i] - places[i - 1]) * height;
  }

  std::size_t nearest_at(const Quad& x, const Quad& y) const {
    std::size_t nearest = shapes_.size();
    Quad depth = 0;
    for (std::size_t i = 0; i < shapes_.size(); ++i) {
      const Shape& shape = shapes_[i];
      if (!std::all_of(shape.edges.begin(), shape.edges.end(), [&](const auto& e) { return e.at(x, y) > 0; })) continue;
      const Quad here = shape.depth.at(x, y);
      if (nearest < shapes_.size() && (here < depth || (here == depth && shape.order > shapes_[nearest].order)))
        continue;
      nearest = i;
      depth = here;
    }
    return nearest;
  }

  std::vector<Shape> shapes_;
  std::vector<QuadLine> lines_;
};

}  // namespace morphcl::accuracy::testing
