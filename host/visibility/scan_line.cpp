#include "host/visibility/scan_line.hpp"

#include "host/visibility/nearest.hpp"

namespace morphcl::visibility {

namespace {

struct SurfaceSpan {
  int first, end;
  SurfaceId surface;
};

class SpanSweep {
 public:
  SpanSweep(const ScreenSurfaces& surfaces, ShownRows& shown, const std::function<void(const SampleSpan&)>& visit)
      : surfaces_(surfaces), shown_(shown), visit_(visit) {}

  SpanCounts run() {
    std::vector<SurfaceId> by_first_row;
    for (SurfaceId id = 0; id < surfaces_.count(); ++id)
      if (!surfaces_[id].blended && !surfaces_[id].box.empty()) by_first_row.push_back(id);
    std::stable_sort(by_first_row.begin(), by_first_row.end(),
                     [&](SurfaceId a, SurfaceId b) { return surfaces_[a].box.first_y < surfaces_[b].box.first_y; });
    std::size_t next = 0;
    std::vector<SurfaceId> crossed;  // by the row
    for (int y = shown_.rows.next_from(0); y < surfaces_.height; y += shown_.rows.step) {
      std::erase_if(crossed, [&](SurfaceId id) { return surfaces_[id].box.last_y < y; });
      for (; next < by_first_row.size() && surfaces_[by_first_row[next]].box.first_y <= y; ++next)
        if (surfaces_[by_first_row[next]].box.last_y >= y) crossed.push_back(by_first_row[next]);
      if (crossed.empty()) continue;
      counts_.max_active = std::max<std::uint64_t>(counts_.max_active, crossed.size());
      ++counts_.lines;
      spans_.clear();
      for (const SurfaceId id : crossed) add_spans(id, y);
      counts_.spans += spans_.size();
      std::sort(spans_.begin(), spans_.end(), [](const SurfaceSpan& a, const SurfaceSpan& b) {
        return a.first != b.first ? a.first < b.first : a.surface < b.surface;
      });
      sweep(y);
    }
    return counts_;
  }

 private:
  void add_spans(SurfaceId id, int y) {
    const Surface& surface = surfaces_[id];
    const Span span = covered_columns(surface, y);
    if (span.empty()) return;
    if (!surface.cut_by_far) return spans_.push_back({span.first, span.end, id});
    for (int x = span.first; x < span.end;) {  // what the far plane leaves
      const int first = x;
      while (x < span.end && surfaces_.stored->shows(id, x, y)) ++x;
      if (x > first) spans_.push_back({first, x, id});
      if (x == first) ++x;
    }
  }

  void sweep(int y) {
    active_.clear();
    seen_ = {0, 0, no_surface};
    std::size_t next = 0;
    int x = 0;
    while (next < spans_.size() || !active_.empty()) {
      if (active_.empty()) x = std::max(x, spans_[next].first);
      for (; next < spans_.size() && spans_[next].first <= x; ++next)
        if (!is_hidden(spans_[next], y)) active_.push_back(spans_[next]);
      if (active_.empty()) continue;
      int end = next < spans_.size() ? spans_[next].first : surfaces_.width;
      for (const SurfaceSpan& span : active_) end = std::min(end, span.end);
      seen_ = {0, 0, no_surface};
      ++counts_.sample_spans;
      resolve(x, end, y);
      x = end;
      std::erase_if(active_, [&](const SurfaceSpan& span) { return span.end <= x; });
    }
  }

  // Behind what is seen at the end of the last sample span, from its first pixel to its last.
  bool is_hidden(const SurfaceSpan& span, int y) {
    if (seen_.surface == no_surface || seen_.end < span.end) return false;
    counts_.comparisons += 1;
    if (!hides_in_window(surfaces_[seen_.surface], surfaces_[span.surface], {span.first, y, span.end - 1, y}))
      return false;
    ++counts_.hidden;
    return true;
  }

  void resolve(int first, int end, int y) {
    if (active_.size() == 1) return fill(first, end, y, active_.front());
    const std::size_t at_first = nearest_by_plane(first, y), at_last = nearest_by_plane(end - 1, y);
    if (at_first == at_last && hides_all(active_[at_first].surface, first, end, y))
      return fill(first, end, y, active_[at_first]);
    if (end - first == 1) {
      NearestAtPixel nearest(surfaces_, first, y);
      for (const SurfaceSpan& span : active_) nearest.add(span.surface);
      nearest.show(shown_);
      counts_.comparisons += nearest.comparisons();
      ++counts_.pixels;
      if (visit_) visit_({y, first, end, static_cast<std::uint32_t>(active_.size()), no_surface});
      return;
    }
    ++counts_.halved;
    const int middle = first + (end - first) / 2;
    resolve(first, middle, y);
    resolve(middle, end, y);
  }

  std::size_t nearest_by_plane(int x, int y) {
    std::size_t nearest = 0;
    double nearest_depth = surfaces_[active_[0].surface].depth.at(x, y);
    for (std::size_t i = 1; i < active_.size(); ++i) {
      const double depth = surfaces_[active_[i].surface].depth.at(x, y);
      if (depth <= nearest_depth) continue;
      nearest = i;
      nearest_depth = depth;
    }
    counts_.comparisons += active_.size() - 1;
    return nearest;
  }

  bool hides_all(SurfaceId front, int first, int end, int y) {
    counts_.comparisons += active_.size() - 1;
    return std::ranges::all_of(active_, [&](const SurfaceSpan& span) {
      return span.surface == front ||
             hides_in_window(surfaces_[front], surfaces_[span.surface], {first, y, end - 1, y});
    });
  }

  void fill(int first, int end, int y, const SurfaceSpan& span) {
    std::fill_n(&shown_.opaque[shown_.index(first, y)], end - first, span.surface);
    seen_ = span;
    if (visit_) visit_({y, first, end, static_cast<std::uint32_t>(active_.size()), span.surface});
  }

  const ScreenSurfaces& surfaces_;
  ShownRows& shown_;
  const std::function<void(const SampleSpan&)>& visit_;
  std::vector<SurfaceSpan> spans_, active_;  // of the row; of these, those at the sweep's place
  SurfaceSpan seen_{0, 0, no_surface};
  SpanCounts counts_;
};

}  // namespace

void SpanCounts::add(const SpanCounts& other) {
  lines += other.lines;
  spans += other.spans;
  hidden += other.hidden;
  sample_spans += other.sample_spans;
  halved += other.halved;
  pixels += other.pixels;
  comparisons += other.comparisons;
  max_active = std::max(max_active, other.max_active);
}

SpanCounts scan_lines(const ScreenSurfaces& surfaces, ShownRows& shown,
                      const std::function<void(const SampleSpan&)>& visit) {
  return SpanSweep(surfaces, shown, visit).run();
}

}  // namespace morphcl::visibility
