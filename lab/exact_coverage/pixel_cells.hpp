// A pixel cut into convex cells, each of which shows one surface, and their areas.
//
// Real is double, or a number of more digits by which a test judges double. Coordinates are pixels from the pixel's
// centre, |x| and |y| at most 1/2, y downwards.
//
// Bound of the error, u = 2^-53 being double's unit roundoff. The value of a line a x + b y + c that crosses the pixel
// is at most s = |a| + |b| and wrong by 4.5 u s: 2 u s by its coefficients (ExactSum; those of edges are exact), 2.5 u
// s by its evaluation. As s / sqrt(a^2 + b^2) is at most sqrt(2), that is a distance of 6.4 u. Where a line cuts a side
// of a cell, the point lies within 6.4 u of that side, and so within 13 u of the line. A cut thus gives the wrong cell
// an area of at most 37 u, a strip of 13 u to both sides of a line of at most sqrt(2), and moves the cell's outline by
// 9 u. The area of the part of n corners is wrong by 5 n u, and rounded to 2^-61. What remains is taken as the rest of
// the cell's area, so that areas add up to 1 exactly; its error is the same. Cuts that were tried count as those that
// were made: no surface of a pixel is wrong by more than the sum of (50 + 5 n) u over all of them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace morphcl::accuracy {

using CoverageUnits = std::int64_t;  // 2^60 are a pixel
constexpr CoverageUnits whole_pixel = CoverageUnits{1} << 60;
constexpr double pixels_of(CoverageUnits units) { return static_cast<double>(units) * 0x1p-60; }

template <class Real>
struct PixelPoint {
  Real x, y;
};

// Inside is where a x + b y + c is not negative.
template <class Real>
struct PixelLine {
  Real a, b, c;

  Real at(const PixelPoint<Real>& p) const { return a * p.x + (b * p.y + c); }
  Real size() const {
    using std::abs;
    return abs(a) + abs(b);
  }
};

template <class Real>
struct PixelBox {
  Real low_x, high_x, low_y, high_y;

  static PixelBox around(std::span<const PixelPoint<Real>> points) {
    PixelBox box{points[0].x, points[0].x, points[0].y, points[0].y};
    for (const PixelPoint<Real>& p : points) {
      box.low_x = std::min(box.low_x, p.x);
      box.high_x = std::max(box.high_x, p.x);
      box.low_y = std::min(box.low_y, p.y);
      box.high_y = std::max(box.high_y, p.y);
    }
    return box;
  }
  // How far the two lie apart along x or y; negative where they overlap.
  Real gap(const PixelBox& other) const {
    return std::max({low_x - other.high_x, other.low_x - high_x, low_y - other.high_y, other.low_y - high_y});
  }
};

template <class Real>
struct Nearness {
  enum Kind { in_front, behind, along_line } kind;
  PixelLine<Real> line;  // inside is in front
};

template <class Real>
class PixelCells {
 public:
  using Polygon = std::vector<PixelPoint<Real>>;

  static constexpr int nothing = -1;
  struct Cell {
    Polygon polygon;
    CoverageUnits area;
    int surface;  // or nothing
    PixelBox<Real> box;
  };

  // The whole pixel shows nothing.
  void start() {
    const Real low(-0.5), high(0.5);
    cells_.clear();
    cells_.push_back(
        {{{low, low}, {high, low}, {high, high}, {low, high}}, whole_pixel, nothing, {low, high, low, high}});
    error_bound_ = 0;
  }

  // `surface` lies inside of all `edges` and of the box; nearness(other) says where it is in front of another one, or
  // of nothing. Returns whether it shows.
  template <class NearnessTo>
  bool cover(int surface, const PixelBox<Real>& box, std::span<const PixelLine<Real>> edges,
             const NearnessTo& nearness) {
    const std::size_t before = cells_.size();
    bool shows = false;
    for (std::size_t i = 0; i < before; ++i) {
      if (const Real gap = box.gap(cells_[i].box); gap >= 0) {
        if (gap < Real(0x1p-40)) error_bound_ += 50 * u;  // a cut along the side of the box
        continue;
      }
      const Nearness<Real> near = nearness(cells_[i].surface);
      if (near.kind == Nearness<Real>::behind) continue;
      rest_ = cells_[i];
      cut_away_.clear();
      bool some = true;
      for (const PixelLine<Real>& edge : edges) some = some && keep_inside(edge);
      if (near.kind == Nearness<Real>::along_line) some = some && keep_inside(near.line);
      if (!some) continue;
      shows = true;
      rest_.surface = surface;
      rest_.box = PixelBox<Real>::around(rest_.polygon);
      std::swap(cells_[i], rest_);
      for (Cell& part : cut_away_) cells_.push_back(std::move(part));
    }
    return shows;
  }

  const std::vector<Cell>& cells() const { return cells_; }
  double error_bound() const { return error_bound_; }

 private:
  static constexpr double u = 0x1p-53;

  // Cuts rest_ at the line; what lies outside goes to cut_away_. False when nothing is left.
  bool keep_inside(const PixelLine<Real>& line) {
    using std::abs;
    const Real beyond = line.size() * Real(0.5 + 0x1p-48);
    if (line.c > beyond) return true;
    if (line.c < -beyond) return false;
    const std::size_t corners = rest_.polygon.size();
    values_.clear();
    bool positive = false, negative = false, close = false;
    for (const PixelPoint<Real>& p : rest_.polygon) {
      const Real value = line.at(p);
      values_.push_back(value);
      positive = positive || value > 0;
      negative = negative || value < 0;
      close = close || abs(value) <= line.size() * Real(8 * u);
    }
    if (close || (positive && negative)) error_bound_ += (50 + 5 * static_cast<double>(corners)) * u;
    if (!negative) return true;
    if (!positive) return false;
    Polygon inside, outside;
    for (std::size_t i = 0; i < corners; ++i) {
      const std::size_t next = i + 1 == corners ? 0 : i + 1;
      const PixelPoint<Real>&p = rest_.polygon[i], &q = rest_.polygon[next];
      if (!(values_[i] < 0)) inside.push_back(p);
      if (!(values_[i] > 0)) outside.push_back(p);
      if ((values_[i] > 0 && values_[next] < 0) || (values_[i] < 0 && values_[next] > 0)) {
        const Real t = values_[i] / (values_[i] - values_[next]);
        const PixelPoint<Real> cut{p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)};
        inside.push_back(cut);
        outside.push_back(cut);
      }
    }
    const CoverageUnits area = std::clamp<CoverageUnits>(units_of(inside), 0, rest_.area), others = rest_.area - area;
    if (area == 0) return false;
    if (others > 0) {
      const PixelBox<Real> box = PixelBox<Real>::around(outside);
      cut_away_.push_back({std::move(outside), others, rest_.surface, box});
    }
    rest_.polygon = std::move(inside);
    rest_.area = area;
    return true;
  }

  static CoverageUnits units_of(const Polygon& polygon) {
    Real doubled(0);
    const PixelPoint<Real>& first = polygon.front();
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
      const PixelPoint<Real>&p = polygon[i], &q = polygon[i + 1];
      doubled += (p.x - first.x) * (q.y - first.y) - (p.y - first.y) * (q.x - first.x);
    }
    return doubled > 0 ? static_cast<CoverageUnits>(doubled * Real(0x1p59) + Real(0.5)) : 0;
  }

  std::vector<Cell> cells_, cut_away_;
  Cell rest_;
  std::vector<Real> values_;
  double error_bound_ = 0;
};

}  // namespace morphcl::accuracy
