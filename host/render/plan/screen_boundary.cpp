#include "host/render/plan/screen_boundary.hpp"

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <utility>

namespace morphcl {

namespace {

constexpr std::uint32_t empty = ~std::uint32_t{0};

bool before(const GridPoint& a, const GridPoint& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; }

// Multiplicative (Knuth, The Art of Computer Programming 6.4), the best bits are the high ones.
std::uint64_t hash(const GridPoint& a, const GridPoint& b) {
  std::uint64_t h = 0;
  for (const std::int64_t value : {a.x, a.y, b.x, b.y})
    h = (std::rotl(h, 23) ^ static_cast<std::uint64_t>(value)) * 0x9e3779b97f4a7c15u;
  return h;
}

}  // namespace

ScreenBoundary::ScreenBoundary(std::size_t max_triangles) : slots_(std::bit_ceil(6 * max_triangles + 2), empty) {
  edges_.reserve(3 * max_triangles);
}

void ScreenBoundary::add(const GridPoint& a, const GridPoint& b, const GridPoint& c) {
  add_edge(a, b);
  add_edge(b, c);
  add_edge(c, a);
}

void ScreenBoundary::add_edge(const GridPoint& from, const GridPoint& to) {
  const bool forward = before(from, to);
  const GridPoint &first = forward ? from : to, &second = forward ? to : from;
  const std::size_t mask = slots_.size() - 1;
  std::size_t slot = hash(first, second) >> (64 - std::countr_zero(slots_.size()));
  for (;; slot = (slot + 1) & mask) {
    if (slots_[slot] == empty) {
      slots_[slot] = static_cast<std::uint32_t>(edges_.size());
      edges_.push_back({first, second, 0});
      break;
    }
    const Edge& found = edges_[slots_[slot]];
    if (found.from == first && found.to == second) break;
  }
  edges_[slots_[slot]].times += forward ? 1 : -1;
}

void ScreenBoundary::finish() {
  for (const Edge& edge : edges_)
    for (int i = 0; i < std::abs(edge.times); ++i)
      boundary_.push_back(edge.times > 0 ? DirectedEdge{edge.from, edge.to} : DirectedEdge{edge.to, edge.from});
}

bool ScreenBoundary::is_star_shaped() const {
  if (boundary_.empty()) return true;
  // Any point may be tried; the middle of the corners is inside wherever the boundary is convex.
  GridPoint sum{0, 0};
  for (const auto& [from, to] : boundary_) {
    sum.x += from.x;
    sum.y += from.y;
  }
  const auto corners = static_cast<std::int64_t>(boundary_.size());
  const GridPoint middle{sum.x / corners, sum.y / corners};

  int rounds = 0;
  for (const auto& [from, to] : boundary_) {
    const std::int64_t area = doubled_area(middle, from, to);
    const std::int64_t along = (from.x - middle.x) * (to.x - middle.x) + (from.y - middle.y) * (to.y - middle.y);
    if (area < 0 || (area == 0 && along <= 0)) return false;
    // Edges that run this way round cross the ray from the middle towards +x upwards, once a round.
    rounds += from.y <= middle.y && to.y > middle.y;
  }
  return rounds == 1;
}

bool ScreenBoundary::is_convex() const {
  return std::all_of(boundary_.begin(), boundary_.end(), [this](const DirectedEdge& edge) {
    return std::all_of(boundary_.begin(), boundary_.end(),
                       [&](const DirectedEdge& other) { return doubled_area(edge.from, edge.to, other.from) >= 0; });
  });
}

}  // namespace morphcl
