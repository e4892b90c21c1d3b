// The boundary of a set of triangles on the integer grid of sub-pixels: which of their edges have no partner.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace morphcl {

struct GridPoint {
  std::int64_t x, y;  // within +-2^24, so that products of differences fit into 64 bits
  bool operator==(const GridPoint&) const = default;
};

// Of the triangle a b c; positive where it turns from x towards y.
inline std::int64_t doubled_area(const GridPoint& a, const GridPoint& b, const GridPoint& c) {
  return (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
}

// Triangles are added one by one, all turning the same way, from x towards y; then finish() is called once. An edge
// that runs from p to q in one triangle and from q to p in another is inside; what is left is the boundary. Exact,
// linear in the triangles.
class ScreenBoundary {
 public:
  explicit ScreenBoundary(std::size_t max_triangles);

  void add(const GridPoint& a, const GridPoint& b, const GridPoint& c);

  void finish();

  // Every boundary edge runs from x towards y around one common point, and together they go round it once. Then no
  // point is covered twice. True without triangles.
  bool is_star_shaped() const;
  // Of a boundary that is star-shaped: no corner of it points inwards. Quadratic in its edges.
  bool is_convex() const;

 private:
  struct Edge {
    GridPoint from, to;
    int times;  // more often from `from` to `to` than back
  };
  struct DirectedEdge {
    GridPoint from, to;
  };
  void add_edge(const GridPoint& from, const GridPoint& to);

  std::vector<Edge> edges_;           // each pair of points once
  std::vector<std::uint32_t> slots_;  // open hashing: numbers of edges, or empty
  std::vector<DirectedEdge> boundary_;
};

}  // namespace morphcl
