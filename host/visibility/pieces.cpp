#include "host/visibility/pieces.hpp"

#include <cmath>
#include <limits>
#include <utility>

namespace morphcl::visibility {

namespace {

// By how much a side's function may be wrong at a piece's corners, which are rounded: far more than roundings of fp64
// make, and far less than a pixel. The polygon of a piece is larger by it than the pixels need.
double corner_slack(const DepthPlane& function, const DepthPlane& of_surface) {
  constexpr double pixels = 0x1p-10, rounding = 0x1p-45, reach = 0x1p15;
  const double slope = std::abs(function.dx) + std::abs(function.dy);
  return slope * pixels + rounding * (std::abs(of_surface.at_origin) +
                                      reach * (std::abs(of_surface.dx) + std::abs(of_surface.dy) + slope));
}

}  // namespace

PixelBox box_of(const Polygon& polygon, const PixelBox& within) {
  constexpr double margin = 0x1p-8;  // of rounded corners
  double low_x = std::numeric_limits<double>::infinity(), low_y = low_x, high_x = -low_x, high_y = -low_x;
  for (const glm::dvec2& corner : polygon) {
    low_x = std::min(low_x, corner.x);
    high_x = std::max(high_x, corner.x);
    low_y = std::min(low_y, corner.y);
    high_y = std::max(high_y, corner.y);
  }
  if (polygon.empty()) return {0, 0, -1, -1};
  const auto pixel = [](double value) { return static_cast<int>(std::clamp(value, -0x1p20, 0x1p20)); };
  return intersection(within, {pixel(std::ceil(low_x - margin)), pixel(std::ceil(low_y - margin)),
                               pixel(std::floor(high_x + margin)), pixel(std::floor(high_y + margin))});
}

namespace {

void clip_into(Polygon& left, const Polygon& polygon, const DepthPlane& function, double slack) {
  left.clear();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec2 &a = polygon[i], &b = polygon[i + 1 == polygon.size() ? 0 : i + 1];
    const double at_a = function.at(a.x, a.y) + slack, at_b = function.at(b.x, b.y) + slack;
    if (at_a >= 0) left.push_back(a);
    if ((at_a >= 0) != (at_b >= 0)) left.push_back(a + (b - a) * (at_a / (at_a - at_b)));
  }
}

}  // namespace

Polygon clipped(const Polygon& polygon, const DepthPlane& function, double slack) {
  Polygon left;
  left.reserve(polygon.size() + 1);
  clip_into(left, polygon, function, slack);
  return left;
}

Polygon intersection(const Polygon& a, const Polygon& b) {
  Polygon common, next;
  common.reserve(a.size() + b.size());
  next.reserve(a.size() + b.size());
  common = a;
  for (std::size_t i = 0; i < b.size() && common.size() > 2; ++i) {
    const glm::dvec2 &p = b[i], &q = b[i + 1 == b.size() ? 0 : i + 1];
    const glm::dvec2 along = q - p;
    clip_into(next, common, {along.y * p.x - along.x * p.y, -along.y, along.x}, 0);
    std::swap(common, next);
  }
  return common.size() > 2 ? common : Polygon();
}

Range range_over(const Polygon& polygon, const DepthPlane& function) {
  Range range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (const glm::dvec2& corner : polygon) {
    const double value = function.at(corner.x, corner.y);
    range.min = std::min(range.min, value);
    range.max = std::max(range.max, value);
  }
  return range;
}

Piece Pieces::whole(SurfaceId surface) const {
  const Surface& of = surfaces_[surface];
  Piece piece{surface, -1, of.box, of.min, of.max, {}};
  piece.polygon.reserve(of.corner.size());
  for (const glm::ivec2& corner : of.corner)
    piece.polygon.push_back((glm::dvec2(corner) - double{subpixels} / 2) / double{subpixels});
  return piece;
}

DepthPlane Pieces::function_of(const Splitter& splitter, SurfaceId surface) const {
  const DepthPlane& depth = surfaces_[surface].depth;
  switch (splitter.kind) {
    case Splitter::Kind::plane:
      return depth - surfaces_[splitter.plane].depth;
    case Splitter::Kind::level:
      return {depth.at_origin - splitter.level, depth.dx, depth.dy};
    case Splitter::Kind::column:
      return {0.5 - splitter.position, 1, 0};
    case Splitter::Kind::row:
      break;
  }
  return {0.5 - splitter.position, 0, 1};
}

// Along a row the function never turns, roundings included: what is on its side is one end of the span.
void Pieces::Bounds::Side::shorten(Span& span, int y) const {
  if (span.empty()) return;
  const bool at_first = holds(span.first, y), at_last = holds(span.end - 1, y);
  if (at_first && at_last) return;
  if (!at_first && !at_last) {
    span.end = span.first;
    return;
  }
  // From where the exact function changes its sign to where this one does, which is next to it.
  const double change = -(function.dy * y + function.at_origin) / function.dx;
  int x = static_cast<int>(std::clamp(change, static_cast<double>(span.first), span.end - 1.0));
  while (x > span.first && holds(x - 1, y) == at_last) --x;
  while (holds(x, y) != at_last) ++x;
  (at_first ? span.end : span.first) = x;
}

Pieces::Bounds Pieces::bounds_of(const Piece& piece) const {
  Bounds bounds;
  for (std::int32_t side = piece.side; side >= 0; side = sides_[static_cast<std::size_t>(side)].before) {
    const Side& of = sides_[static_cast<std::size_t>(side)];
    bounds.sides.push_back({function_of(of.splitter, piece.surface), of.front});
  }
  return bounds;
}

Span Pieces::columns_of(const Piece& piece, const Bounds& bounds, int y) const {
  Span span = covered_columns(surfaces_[piece.surface], y);
  span.first = std::max(span.first, piece.box.first_x);
  span.end = std::min(span.end, piece.box.last_x + 1);
  for (const Bounds::Side& side : bounds.sides) side.shorten(span, y);
  return span;
}

Pieces::Sides Pieces::sides_of(const Piece& piece, const DepthPlane& function, double slack) const {
  const auto [min, max] = range_over(piece.polygon, function);
  if (min >= -slack || max <= slack) return {max > slack, min < -slack};
  const Bounds bounds = bounds_of(piece);
  Sides sides;
  for (int y = piece.box.first_y; y <= piece.box.last_y && !(sides.front && sides.back); ++y) {
    const Span span = columns_of(piece, bounds, y);
    if (span.empty()) continue;
    for (const int x : {span.first, span.end - 1}) {
      const double value = function.at(x, y);
      sides.front |= value > slack;
      sides.back |= value < -slack;
    }
  }
  return sides;
}

Piece Pieces::part(const Piece& piece, const Splitter& splitter, const DepthPlane& function, bool front) {
  const Surface& surface = surfaces_[piece.surface];
  const DepthPlane outwards = front ? function : DepthPlane{} - function;
  Piece part = piece;
  part.polygon = clipped(piece.polygon, outwards, corner_slack(function, surface.depth));
  part.box = box_of(part.polygon, piece.box);
  const Range depth = range_over(part.polygon, surface.depth);
  part.min = std::max(piece.min, depth.min - surface.error);
  part.max = std::min(piece.max, depth.max + surface.error);
  part.side = static_cast<std::int32_t>(sides_.size());
  sides_.push_back({splitter, front, piece.side});
  return part;
}

std::pair<Piece, Piece> Pieces::split(const Piece& piece, const Splitter& splitter) {
  const DepthPlane function = function_of(splitter, piece.surface);
  Piece front = part(piece, splitter, function, true), back = part(piece, splitter, function, false);
  return {std::move(front), std::move(back)};
}

}  // namespace morphcl::visibility
