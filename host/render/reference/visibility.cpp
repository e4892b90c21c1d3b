#include "host/render/reference/visibility.hpp"

#include <algorithm>
#include <cmath>

#include "host/render/frame/kernel_layout.hpp"
#include "host/render/frame/raster_grid.hpp"
#include "host/render/frame/sample_pattern.hpp"
#include "host/render/reference/depth_plane.hpp"
#include "host/render/reference/screen_primitives.hpp"
#include "host/render/reference/triangle_box.hpp"

namespace morphcl::reference {

std::int64_t half_thickness(std::int64_t run, std::int64_t rise, std::uint32_t width) {
  const auto along = static_cast<float>(run), across = static_cast<float>(rise);
  const float length = std::sqrt(std::fma(across, across, along * along));
  return std::max(static_cast<int>(std::floor(0.5f * static_cast<float>(width) * (length / along) + 0.5f)), 1);
}

namespace {

// cover(sample's index, Sample) is called for all that primitives cover, if it is before the far plane.
template <class Cover>
class Rasterizer {
 public:
  Rasterizer(const FramePlan& plan, const Visibility& visible, Cover cover)
      : plan_(plan), visible_(visible), cover_(cover), pattern_(sample_pattern(visible.samples_a_pixel)) {
    for (const SampleOffset& sample : pattern_) {
      min_sample_ = std::min(min_sample_, layout::half_pixel + sample.subpixels_x());
      max_sample_ = std::max(max_sample_, layout::half_pixel + sample.subpixels_x());
    }
  }

  // `identity` holds everything of the samples but their depth.
  void triangle(ScreenVertex a, ScreenVertex b, ScreenVertex c, bool double_sided, bool may_be_small,
                const Sample& identity) {
    std::int64_t area = std::int64_t{b.x - a.x} * (c.y - a.y) - std::int64_t{c.x - a.x} * (b.y - a.y);
    if (area == 0 || (area < 0 && !double_sided)) return;
    if (area < 0) {
      std::swap(b, c);
      area = -area;
    }
    const TriangleBox box(plan_, a, b, c, min_sample_, max_sample_);
    const int first_x = box.first_x, first_y = box.first_y, last_x = box.last_x, last_y = box.last_y;
    const Rows rows = visible_.rows;
    const auto fill = [&](const auto& depth_at) {
      for (int y = rows.next_from(std::max(first_y, 0)); y <= last_y; y += rows.step)
        for (int x = std::max(first_x, 0); x <= last_x; ++x)
          for (std::size_t s = 0; s < pattern_.size(); ++s) {
            const int px = pixel_centre(x) + pattern_[s].subpixels_x(),
                      py = pixel_centre(y) + pattern_[s].subpixels_y();
            if (inside(a, b, px, py) && inside(b, c, px, py) && inside(c, a, px, py))
              cover(x, y, s, depth_at(x, y, pattern_[s]), identity);
          }
    };
    // Samples take depth from the plane through the sub-pixels.
    const bool centre = pattern_.size() == 1;
    if (!centre)
      for (ScreenVertex* const corner : {&a, &b, &c}) corner->rest_x = corner->rest_y = 0;
    if (is_forward(plan_.depth_format)) {
      const NormalizedDepthPlane plane(plan_, a, b, c, area);
      fill([&](int x, int y, SampleOffset sample) {
        return centre ? plane.at_centre(x, y) : plane.at_sample(x, y, sample);
      });
      return;
    }
    const bool small = may_be_small && box.is_small();
    if (!small) turn_farthest_first(a, b, c);
    const ReversedPlane plane(a, b, c);
    fill([&](int x, int y, SampleOffset sample) {
      const int origin_x = small ? first_x : origin_in_tile(a.x, x),
                origin_y = small ? first_y : origin_in_tile(a.y, y);
      if (centre) return plane.at_centre(x, y, origin_x, origin_y);
      return small ? plane.at_sample_of_small(x, y, sample, origin_x, origin_y)
                   : plane.at_sample(x, y, sample, origin_x, origin_y);
    });
  }

  void line(const ScreenVertex& a, const ScreenVertex& b, std::uint32_t width, const Sample& identity) {
    if (pattern_.size() == 1 && width == layout::subpixels)
      thin_line(a, b, identity);
    else
      wide_line(a, b, width, identity);
  }

 private:
  // One pixel for each column (or, in steep lines, row).
  void thin_line(ScreenVertex a, ScreenVertex b, const Sample& identity) {
    const bool steep = std::abs(b.y - a.y) > std::abs(b.x - a.x);
    if (steep ? b.y < a.y : b.x < a.x) std::swap(a, b);
    const std::int64_t start = steep ? a.y : a.x, stop = steep ? b.y : b.x, across = steep ? a.x : a.y;
    const std::int64_t run = stop - start, rise = steep ? b.x - a.x : b.y - a.y;
    if (run == 0) return;
    const LineDepth depth(plan_, a, b, steep);
    const int limit = steep ? plan_.height : plan_.width;
    for (int along = 0; along < limit; ++along) {
      const std::int64_t offset = pixel_centre(along) - start;
      if (offset < 0 || offset >= run) continue;
      const std::int64_t numerator = across * run + rise * offset, denominator = run * layout::subpixels;
      const std::int64_t other = numerator / denominator - (numerator % denominator < 0 ? 1 : 0);
      if (other < 0 || other >= (steep ? plan_.width : plan_.height)) continue;
      const int x = steep ? static_cast<int>(other) : along, y = steep ? along : static_cast<int>(other);
      if (visible_.rows.next_from(y) == y) cover(x, y, 0, depth.at(offset), identity);
    }
  }

  // A parallelogram: as long as the line along its longer axis, half open, and half_thickness() to both sides of it.
  void wide_line(ScreenVertex a, ScreenVertex b, std::uint32_t width, const Sample& identity) {
    const bool steep = std::abs(b.y - a.y) > std::abs(b.x - a.x);
    if (steep ? b.y < a.y : b.x < a.x) std::swap(a, b);
    const std::int64_t start = steep ? a.y : a.x, stop = steep ? b.y : b.x, across = steep ? a.x : a.y;
    const std::int64_t run = stop - start, rise = steep ? b.x - a.x : b.y - a.y;
    if (run == 0) return;
    const std::int64_t half = half_thickness(run, rise, width);
    const LineDepth depth(plan_, a, b, steep);
    const int limit = steep ? plan_.height : plan_.width, across_limit = steep ? plan_.width : plan_.height;
    // Of a pixel to the one next to it the line moves by a pixel across at most.
    const auto reach = static_cast<int>(half / layout::subpixels) + 2;
    const int first = std::max(TriangleBox::first_pixel(static_cast<int>(start), max_sample_), 0),
              last = std::min(TriangleBox::last_pixel(static_cast<int>(stop), min_sample_), limit - 1);
    for (int along = first; along <= last; ++along) {
      const std::int64_t centre_offset = pixel_centre(along) - start;
      const std::int64_t numerator = across * run + rise * centre_offset, denominator = run * layout::subpixels;
      const std::int64_t middle = numerator / denominator - (numerator % denominator < 0 ? 1 : 0);
      const auto low = static_cast<int>(std::clamp<std::int64_t>(middle - reach, 0, across_limit)),
                 high = static_cast<int>(std::clamp<std::int64_t>(middle + reach, -1, across_limit - 1));
      for (int other = low; other <= high; ++other) {
        const int x = steep ? other : along, y = steep ? along : other;
        if (visible_.rows.next_from(y) != y) continue;
        for (std::size_t s = 0; s < pattern_.size(); ++s) {
          const SampleOffset sample = pattern_[s];
          const int px = pixel_centre(x) + sample.subpixels_x(), py = pixel_centre(y) + sample.subpixels_y();
          const std::int64_t offset = (steep ? py : px) - start;
          const std::int64_t beside = run * ((steep ? px : py) - across) - rise * offset;
          if (offset < 0 || offset >= run || beside < -half * run || beside >= half * run) continue;
          if (is_forward(plan_.depth_format)) {
            cover(x, y, s, depth.at(offset), identity);
            continue;
          }
          const float centre = depth.at(centre_offset).depth;
          cover(x, y, s, {std::fma(depth.slope(), steep ? sample.pixels_y() : sample.pixels_x(), centre)}, identity);
        }
      }
    }
  }

  // Samples on an edge belong to the triangle whose top or left edge it is.
  static bool inside(const ScreenVertex& from, const ScreenVertex& to, int x, int y) {
    const std::int64_t dx = to.x - from.x, dy = to.y - from.y;
    const std::int64_t value = dx * (y - from.y) - dy * (x - from.x);
    const bool owns_edge = dy < 0 || (dy == 0 && dx > 0);
    return owns_edge ? value >= 0 : value > 0;
  }

  void cover(int x, int y, std::size_t sample, const StoredDepth& stored, const Sample& identity) {
    if (!stored.in_range) return;
    Sample covered = identity;
    covered.depth = stored.depth;
    covered.key = stored.key;
    cover_(visible_.index(x, y) + sample, covered);
  }

  const FramePlan& plan_;
  const Visibility& visible_;
  Cover cover_;
  std::span<const SampleOffset> pattern_;
  int min_sample_ = layout::half_pixel, max_sample_ = layout::half_pixel;  // sub-pixels from the pixel's upper left
};

// Of the opaque draws, or of the blended ones.
template <class Cover>
struct DrawnPrimitives {
  const FramePlan& plan;
  bool blended;
  Visibility& visible;
  Rasterizer<Cover> rasterizer;

  void triangle(const ScreenTriangle& t, const PrimitiveIdentity& identity) {
    if (plan.draws[identity.draw].blended != blended) return;
    rasterizer.triangle(t.a, t.b, t.c, t.double_sided, t.piece == nullptr, sample_of(identity, t.piece));
  }
  void line(const ScreenLine& line, const PrimitiveIdentity& identity) {
    if (plan.draws[identity.draw].blended != blended) return;
    rasterizer.line(line.from, line.to, line.width, sample_of(identity, line.piece));
  }

  Sample sample_of(const PrimitiveIdentity& identity, const Piece* piece) {
    Sample sample{0, 0, identity.order, identity.draw, identity.primitive, no_piece};
    if (!piece) return sample;
    sample.piece = static_cast<std::uint32_t>(visible.pieces.size());
    visible.pieces.push_back(*piece);
    return sample;
  }
};

template <class Cover>
void cover_samples(const FramePlan& plan, const RasterGrid& grid, const std::vector<std::vector<Vertex>>& vertices,
                   bool blended, Visibility& visible, Cover cover) {
  const Rasterizer<Cover> rasterizer(plan, visible, cover);
  for_each_screen_primitive(plan, grid, vertices, DrawnPrimitives<Cover>{plan, blended, visible, rasterizer});
}

// Lines alone, of the opaque draws or of the blended ones.
template <class Cover>
struct DrawnLines {
  DrawnPrimitives<Cover> drawn;

  void triangle(const ScreenTriangle& /*t*/, const PrimitiveIdentity& /*identity*/) {}
  void line(const ScreenLine& line, const PrimitiveIdentity& identity) { drawn.line(line, identity); }
};

template <class Cover>
void cover_samples_by_lines(const FramePlan& plan, const RasterGrid& grid,
                            const std::vector<std::vector<Vertex>>& vertices, bool blended, Visibility& visible,
                            Cover cover) {
  const Rasterizer<Cover> rasterizer(plan, visible, cover);
  for_each_screen_primitive(plan, grid, vertices, DrawnLines<Cover>{{plan, blended, visible, rasterizer}});
}

// Takes what comes to a sample into the picture.
auto nearest_of(const FramePlan& plan, Visibility& visible) {
  return [&plan, &visible](std::size_t index, const Sample& covered) {
    Sample& held = visible.samples[index];
    if (is_nearer(plan, covered, held) || (is_as_far(plan, covered, held) && covered.order < held.order))
      held = covered;
  };
}

auto layers_in_front(const FramePlan& plan, Visibility& visible) {
  return [&plan, &visible](std::size_t index, const Sample& covered) {
    if (is_layer_in_front(plan, covered, visible.samples[index])) visible.layers.push_back({index, covered});
  };
}

}  // namespace

void find_layers(const FramePlan& plan, const RasterGrid& grid, const std::vector<std::vector<Vertex>>& vertices,
                 Visibility& visible) {
  cover_samples(plan, grid, vertices, true, visible, layers_in_front(plan, visible));
  sort_layers(plan, visible);
}

void add_lines(const FramePlan& plan, const RasterGrid& grid, const std::vector<std::vector<Vertex>>& vertices,
               Visibility& visible) {
  cover_samples_by_lines(plan, grid, vertices, false, visible, nearest_of(plan, visible));
}

void add_layers_of_lines(const FramePlan& plan, const RasterGrid& grid,
                         const std::vector<std::vector<Vertex>>& vertices, Visibility& visible) {
  const std::size_t before = visible.layers.size();
  cover_samples_by_lines(plan, grid, vertices, true, visible, layers_in_front(plan, visible));
  if (visible.layers.size() != before) sort_layers(plan, visible);
}

void sort_layers(const FramePlan& plan, Visibility& visible) {
  std::sort(visible.layers.begin(), visible.layers.end(), [&](const Layer& a, const Layer& b) {
    if (a.index != b.index) return a.index < b.index;
    if (!is_as_far(plan, a.surface, b.surface)) return is_nearer(plan, a.surface, b.surface);
    return a.surface.order > b.surface.order;
  });
}

std::span<const Layer> Visibility::layers_of(std::size_t sample) const {
  const auto [first, end] = std::ranges::equal_range(layers, sample, {}, &Layer::index);
  return {first, end};
}

Visibility find_visible(const FramePlan& plan, const RasterGrid& grid,
                        const std::vector<std::vector<Vertex>>& vertices) {
  Visibility visible;
  find_visible(plan, grid, vertices, {}, 1, visible);
  return visible;
}

void clear(const FramePlan& plan, const Rows& rows, int samples_a_pixel, Visibility& visible) {
  visible.rows = rows;
  visible.width = plan.width;
  visible.samples_a_pixel = samples_a_pixel;
  visible.pieces.clear();
  visible.layers.clear();
  visible.samples.assign(static_cast<std::size_t>(plan.width) * static_cast<std::size_t>(rows.count(plan.height)) *
                             static_cast<std::size_t>(samples_a_pixel),
                         {plan.camera.far_depth, 0, no_order, 0, 0, no_piece});
}

void find_visible(const FramePlan& plan, const RasterGrid& grid, const std::vector<std::vector<Vertex>>& vertices,
                  const Rows& rows, int samples_a_pixel, Visibility& visible) {
  clear(plan, rows, samples_a_pixel, visible);
  cover_samples(plan, grid, vertices, false, visible, nearest_of(plan, visible));
  if (plan.blends) find_layers(plan, grid, vertices, visible);
}

}  // namespace morphcl::reference
