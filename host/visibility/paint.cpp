#include "host/visibility/paint.hpp"

#include <cmath>

namespace morphcl::visibility {

namespace {

// Whether the stored depths have what is painted now behind what was painted before.
bool belongs_behind(const ScreenSurfaces& surfaces, SurfaceId now, SurfaceId before, int x, int y) {
  const Surface &a = surfaces[now], &b = surfaces[before];
  return std::abs(a.depth.at(x, y) - b.depth.at(x, y)) <= a.error + b.error &&
         surfaces.stored->is_in_front(before, now, x, y);
}

// Layers of a pixel side by side, from back to front.
void order_layers(const ScreenSurfaces& surfaces, ShownRows& shown) {
  std::stable_sort(shown.layers.begin(), shown.layers.end(),
                   [](const ShownRows::Layer& a, const ShownRows::Layer& b) { return a.pixel < b.pixel; });
  for (std::size_t i = 1; i < shown.layers.size(); ++i) {
    const std::size_t pixel = shown.layers[i].pixel, row = pixel / static_cast<std::size_t>(shown.width);
    const int x = static_cast<int>(pixel % static_cast<std::size_t>(shown.width)),
              y = shown.rows.first + static_cast<int>(row) * shown.rows.step;
    for (std::size_t k = i; k > 0 && shown.layers[k - 1].pixel == pixel; --k) {
      if (!belongs_behind(surfaces, shown.layers[k].surface, shown.layers[k - 1].surface, x, y)) break;
      std::swap(shown.layers[k], shown.layers[k - 1]);
      shown.within_error.push_back({pixel, shown.layers[k].surface, shown.layers[k - 1].surface});
    }
  }
}

}  // namespace

void paint(const Pieces& pieces, const std::vector<Piece>& back_to_front, ShownRows& shown) {
  const ScreenSurfaces& surfaces = pieces.surfaces();
  for (const Piece& piece : back_to_front) {
    const Surface& surface = surfaces[piece.surface];
    if (shown.rows.next_from(piece.box.first_y) > piece.box.last_y) continue;
    const Pieces::Bounds bounds = pieces.bounds_of(piece);
    for (int y = shown.rows.next_from(piece.box.first_y); y <= piece.box.last_y; y += shown.rows.step) {
      const Span span = pieces.columns_of(piece, bounds, y);
      for (int x = span.first; x < span.end; ++x) {
        if (surface.cut_by_far && !surfaces.stored->shows(piece.surface, x, y)) continue;
        const std::size_t pixel = shown.index(x, y);
        if (surface.blended) {
          shown.layers.push_back({pixel, piece.surface});
          continue;
        }
        SurfaceId& held = shown.opaque[pixel];
        if (held != no_surface && belongs_behind(surfaces, piece.surface, held, x, y))
          shown.within_error.push_back({pixel, held, piece.surface});
        else
          held = piece.surface;
      }
    }
  }
  std::erase_if(shown.within_error,
                [&](const ShownRows::WithinError& of) { return shown.opaque[of.pixel] != of.shown; });  // painted over
  order_layers(surfaces, shown);
}

}  // namespace morphcl::visibility
