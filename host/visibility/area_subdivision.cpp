#include "host/visibility/area_subdivision.hpp"

#include <bit>

#include "host/visibility/nearest.hpp"

namespace morphcl::visibility {

namespace {

class Subdivision {
 public:
  Subdivision(const ScreenSurfaces& surfaces, ShownRows& shown, const std::function<void(const Window&)>& visit)
      : surfaces_(surfaces), shown_(shown), visit_(visit) {}

  WindowCounts run() {
    for (SurfaceId id = 0; id < surfaces_.count(); ++id)
      if (!surfaces_[id].blended && !surfaces_[id].box.empty()) lists_.push_back(id);
    const unsigned side = static_cast<unsigned>(std::max({surfaces_.width, surfaces_.height, 1}));
    resolve(0, 0, static_cast<int>(std::bit_ceil(side)), 0, lists_.size(), 1);
    return counts_;
  }

 private:
  // Of the surfaces lists_[first, end), which the window around this one has left.
  void resolve(int x, int y, int size, std::size_t first, std::size_t end, int depth) {
    const PixelBox window{x, y, std::min(x + size, surfaces_.width) - 1, std::min(y + size, surfaces_.height) - 1};
    if (window.empty()) return;
    counts_.max_depth = std::max(counts_.max_depth, depth);
    const std::size_t own = lists_.size();
    Window about{x, y, size, WindowCase::divided, 0, 0, 0, 0};
    SurfaceId front = no_surface;  // of what surrounds the window, the nearest in its middle
    double front_depth = 0;
    for (std::size_t i = first; i < end; ++i) {
      const SurfaceId id = lists_[i];
      const Surface& surface = surfaces_[id];
      const WindowRelation relation = relation_to_window(surface, window);
      ++counts_.relations[static_cast<std::size_t>(relation)];
      ++(relation == WindowRelation::outside    ? about.outside
         : relation == WindowRelation::crossing ? about.crossing
                                                : about.surrounding);
      if (relation == WindowRelation::outside) continue;
      lists_.push_back(id);
      if (relation != WindowRelation::surrounding || surface.cut_by_far) continue;
      const double at_middle =
          surface.depth.at(0.5 * (window.first_x + window.last_x), 0.5 * (window.first_y + window.last_y));
      if (front != no_surface && at_middle <= front_depth) continue;
      front = id;
      front_depth = at_middle;
    }
    if (front != no_surface) about.hidden = drop_hidden(own, front, window);
    about.ended = ending(own, front, size);
    ++counts_.windows[static_cast<std::size_t>(about.ended)];
    if (visit_) visit_(about);
    switch (about.ended) {
      case WindowCase::empty:
        break;
      case WindowCase::surrounded:
        fill(front, window);
        break;
      case WindowCase::single:
        draw(lists_[own], window);
        break;
      case WindowCase::pixel:
        decide(own, x, y);
        break;
      case WindowCase::divided: {
        const std::size_t last = lists_.size();
        const int half = size / 2;
        for (const int dy : {0, half})
          for (const int dx : {0, half}) resolve(x + dx, y + dy, half, own, last, depth + 1);
      }
    }
    lists_.resize(own);
  }

  std::uint32_t drop_hidden(std::size_t own, SurfaceId front, const PixelBox& window) {
    const Surface& surface = surfaces_[front];
    counts_.depths += lists_.size() - own;
    const auto hidden =
        std::remove_if(lists_.begin() + static_cast<std::ptrdiff_t>(own), lists_.end(),
                       [&](SurfaceId id) { return id != front && hides_in_window(surface, surfaces_[id], window); });
    const auto count = static_cast<std::uint32_t>(lists_.end() - hidden);
    lists_.erase(hidden, lists_.end());
    counts_.hidden += count;
    return count;
  }

  WindowCase ending(std::size_t own, SurfaceId front, int size) const {
    const std::size_t left = lists_.size() - own;
    if (left == 0) return WindowCase::empty;
    if (left == 1) return front == no_surface ? WindowCase::single : WindowCase::surrounded;
    return size == 1 ? WindowCase::pixel : WindowCase::divided;
  }

  void fill(SurfaceId id, const PixelBox& window) {
    for (int y = window.first_y; y <= window.last_y; ++y)
      std::fill_n(&shown_.opaque[shown_.index(window.first_x, y)], window.last_x - window.first_x + 1, id);
  }

  void draw(SurfaceId id, const PixelBox& window) {
    const Surface& surface = surfaces_[id];
    const PixelBox common = intersection(window, surface.box);
    for (int y = common.first_y; y <= common.last_y; ++y) {
      const Span span = covered_columns(surface, y);
      for (int x = std::max(span.first, window.first_x); x < std::min(span.end, window.last_x + 1); ++x)
        if (!surface.cut_by_far || surfaces_.stored->shows(id, x, y)) shown_.opaque[shown_.index(x, y)] = id;
    }
  }

  void decide(std::size_t own, int x, int y) {
    NearestAtPixel nearest(surfaces_, x, y);
    for (std::size_t i = own; i < lists_.size(); ++i)
      if (relation_to_window(surfaces_[lists_[i]], {x, y, x, y}) == WindowRelation::surrounding) nearest.add(lists_[i]);
    counts_.depths += nearest.comparisons();
    nearest.show(shown_);
  }

  const ScreenSurfaces& surfaces_;
  ShownRows& shown_;
  const std::function<void(const Window&)>& visit_;
  std::vector<SurfaceId> lists_;  // of the window and of those around it, one after the other
  WindowCounts counts_;
};

}  // namespace

WindowCounts subdivide(const ScreenSurfaces& surfaces, ShownRows& shown,
                       const std::function<void(const Window&)>& visit) {
  return Subdivision(surfaces, shown, visit).run();
}

}  // namespace morphcl::visibility
