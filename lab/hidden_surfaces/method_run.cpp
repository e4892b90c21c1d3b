#include "lab/hidden_surfaces/method_run.hpp"

#include <algorithm>
#include <ctime>
#include <numeric>

namespace morphcl::hidden_surfaces {

namespace {

std::vector<std::vector<reference::Vertex>> projected(const FramePlan& plan, const RasterGrid& grid) {
  std::vector<std::vector<reference::Vertex>> vertices;
  for (const Draw& draw : plan.draws) vertices.push_back(reference::project_vertices(draw, plan, grid));
  return vertices;
}

}  // namespace

MethodRun::MethodRun(const Plan& of)
    : plan(of),
      grid(plan->width, plan->height),
      vertices(projected(*plan, grid)),
      frame(*plan, grid, vertices),
      pieces(frame.surfaces()),
      shown({}, plan->width, plan->height) {
  count("surfaces", frame.surfaces().count());
  const std::clock_t start = std::clock();
  run();
  seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  // Told by a second run, so that telling takes no part in the time.
  if (method() == VisibilityMethod::warnock || method() == VisibilityMethod::watkins) {
    visibility::ShownRows again({}, plan->width, plan->height);
    if (method() == VisibilityMethod::warnock)
      visibility::subdivide(frame.surfaces(), again,
                            [&](const visibility::Window& window) { windows.push_back(window); });
    else
      visibility::scan_lines(frame.surfaces(), again,
                             [&](const visibility::SampleSpan& span) { spans.push_back(span); });
  }
  count_overdraw();
  compare_with_z_buffer();
  count("pixels decided within the depth error", shown.within_error.size());
  count("pixels that differ from the z-buffer", differing.size());
}

void MethodRun::run() {
  const visibility::ScreenSurfaces& surfaces = frame.surfaces();
  switch (method()) {
    case VisibilityMethod::painter: {
      visibility::DepthSort sorted = visibility::sort_by_depth(pieces, max_visibility_pieces);
      order = std::move(sorted.back_to_front);
      const visibility::DepthSortCounts& c = sorted.counts;
      count("pairs compared", c.pairs);
      count("rejected: behind altogether (min-max in z)", c.min_max_depth);
      count("rejected: boxes apart (min-max in x, y)", c.min_max_screen);
      count("rejected: behind the other's plane", c.behind_plane);
      count("rejected: the other is in front of its plane", c.in_front_of_plane);
      count("rejected: they share no pixel", c.apart);
      count("rejected: behind where they share pixels", c.behind);
      count("moved before", c.moved);
      count("overlaps in a circle", c.circles);
      count("surfaces that cut each other", c.cuts);
      count("splits", c.splits);
      count("pieces", order.size());
      visibility::paint(pieces, order, shown);
      break;
    }
    case VisibilityMethod::bsp: {
      tree = visibility::build_bsp(pieces, max_visibility_pieces);
      for (const std::uint32_t i : tree->back_to_front()) order.push_back(tree->pieces[i]);
      const visibility::BspCounts& c = tree->counts;
      count("pieces compared with splitters", c.sides);
      count("nodes", tree->nodes.size());
      count("nodes parted by a surface's plane", c.planes);
      count("nodes parted by a line of the screen", c.lines);
      count("nodes parted by a depth", c.levels);
      count("leaves", c.leaves);
      count("depth of the tree", c.max_depth);
      count("splits", c.splits);
      count("pieces", order.size());
      visibility::paint(pieces, order, shown);
      break;
    }
    case VisibilityMethod::warnock: {
      const visibility::WindowCounts c = visibility::subdivide(surfaces, shown);
      count("windows divided", c.windows[static_cast<int>(visibility::WindowCase::divided)]);
      count("windows ended: empty", c.windows[static_cast<int>(visibility::WindowCase::empty)]);
      count("windows ended: one surface", c.windows[static_cast<int>(visibility::WindowCase::single)]);
      count("windows ended: a surface surrounds it and hides the rest",
            c.windows[static_cast<int>(visibility::WindowCase::surrounded)]);
      count("windows ended: one pixel", c.windows[static_cast<int>(visibility::WindowCase::pixel)]);
      count("relations: outside", c.relations[static_cast<int>(visibility::WindowRelation::outside)]);
      count("relations: crossing or within", c.relations[static_cast<int>(visibility::WindowRelation::crossing)]);
      count("relations: surrounding", c.relations[static_cast<int>(visibility::WindowRelation::surrounding)]);
      count("dropped behind a surrounding surface", c.hidden);
      count("depths compared", c.depths);
      count("depth of the quadtree", static_cast<std::uint64_t>(c.max_depth));
      break;
    }
    case VisibilityMethod::watkins: {
      const visibility::SpanCounts c = visibility::scan_lines(surfaces, shown);
      count("scan lines", c.lines);
      count("spans of surfaces", c.spans);
      count("spans left out behind what is seen", c.hidden);
      count("sample spans", c.sample_spans);
      count("sample spans halved", c.halved);
      count("single pixels", c.pixels);
      count("depths compared", c.comparisons);
      count("surfaces on one scan line at most", c.max_active);
      break;
    }
    case VisibilityMethod::z_buffer: {
      reference::Visibility visible;
      reference::find_visible(*plan, grid, vertices, {}, 1, visible);
      std::vector<visibility::SurfaceId> ids(surfaces.count());  // in drawing order
      std::iota(ids.begin(), ids.end(), 0u);
      for (std::size_t i = 0; i < visible.samples.size(); ++i) {
        const std::uint64_t drawn = visible.samples[i].order;
        const auto found = std::lower_bound(ids.begin(), ids.end(), drawn, [&](auto id, std::uint64_t value) {
          return frame.identity(id).order < value;
        });
        if (found != ids.end() && frame.identity(*found).order == drawn) shown.opaque[i] = *found;
      }
      break;
    }
  }
}

void MethodRun::count_overdraw() {
  overdraw.assign(shown.opaque.size(), 0);
  const visibility::ScreenSurfaces& surfaces = frame.surfaces();
  std::uint64_t sum = 0, covered = 0, most = 0;
  for (visibility::SurfaceId id = 0; id < surfaces.count(); ++id)
    for (int y = surfaces[id].box.first_y; y <= surfaces[id].box.last_y; ++y) {
      const visibility::Span span = visibility::covered_columns(surfaces[id], y);
      for (int x = span.first; x < span.end; ++x) ++overdraw[shown.index(x, y)];
    }
  for (const std::uint32_t count : overdraw) {
    sum += count;
    covered += count > 0;
    most = std::max<std::uint64_t>(most, count);
  }
  count("fragments", sum);
  count("pixels covered", covered);
  count("depth of overdraw at most", most);
}

void MethodRun::compare_with_z_buffer() {
  if (method() == VisibilityMethod::z_buffer) return;
  reference::Visibility visible;
  reference::find_visible(*plan, grid, vertices, {}, 1, visible);
  for (std::size_t i = 0; i < visible.samples.size(); ++i) {
    const reference::Sample& expected = visible.samples[i];
    const visibility::SurfaceId id = shown.opaque[i];
    const bool line = expected.order != reference::no_order && plan->draws[expected.draw].shading == Shading::wireframe;
    if (!line && expected.order != (id == visibility::no_surface ? reference::no_order : frame.identity(id).order))
      differing.push_back(i);
  }
}

}  // namespace morphcl::hidden_surfaces
