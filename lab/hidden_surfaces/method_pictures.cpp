#include "lab/hidden_surfaces/method_pictures.hpp"

#include <array>
#include <cmath>

namespace morphcl::hidden_surfaces {

namespace {

constexpr Rgb nothing{16, 16, 20}, line_color{24, 24, 28}, decided{225, 30, 40};

Rgb mixed(const Rgb& a, const Rgb& b, double share_of_b) {
  const auto mix = [&](std::uint8_t p, std::uint8_t q) {
    return static_cast<std::uint8_t>(std::lround(p + (q - p) * share_of_b));
  };
  return {mix(a.red, b.red), mix(a.green, b.green), mix(a.blue, b.blue)};
}

// From 0 to 1, along the colours.
template <std::size_t Count>
Rgb along(const std::array<Rgb, Count>& colors, double place) {
  const double at = std::clamp(place, 0.0, 1.0) * (Count - 1);
  const auto first = std::min(static_cast<std::size_t>(at), Count - 2);
  return mixed(colors[first], colors[first + 1], at - static_cast<double>(first));
}

// Neighbours in drawing order get hues far apart.
Rgb color_of(visibility::SurfaceId surface) {
  if (surface == visibility::no_surface) return nothing;
  static constexpr std::array<Rgb, 7> wheel = {Rgb{228, 120, 110}, Rgb{226, 190, 100}, Rgb{160, 205, 110},
                                               Rgb{105, 200, 165}, Rgb{110, 165, 225}, Rgb{175, 135, 225},
                                               Rgb{228, 120, 110}};
  const double golden = 0.6180339887498949 * surface;
  return along(wheel, golden - std::floor(golden));
}

// A picture in which a pixel of the frame is a square of `scale`.
class Magnified {
 public:
  Magnified(const MethodRun& run, int min_width)
      : scale_(std::max(1, (min_width + run.plan->width - 1) / run.plan->width)),
        image_(run.plan->width * scale_, run.plan->height * scale_, nothing) {}

  int scale() const { return scale_; }
  RgbImage take() { return std::move(image_); }

  // Of pixels from (x, y) on; what leaves the picture is left out.
  void fill(int x, int y, int width, int height, const Rgb& color) {
    rectangle(x * scale_, y * scale_, width * scale_, height * scale_, color);
  }
  // The upper and left side of the same.
  void outline(int x, int y, int width, int height, const Rgb& color, bool upper = true, bool left = true) {
    if (upper) rectangle(x * scale_, y * scale_, width * scale_, 1, color);
    if (left) rectangle(x * scale_, y * scale_, 1, height * scale_, color);
  }

 private:
  void rectangle(int x, int y, int width, int height, const Rgb& color) {
    for (int row = y; row < std::min(y + height, image_.height); ++row)
      for (int column = x; column < std::min(x + width, image_.width); ++column) image_.at(column, row) = color;
  }
  int scale_;
  RgbImage image_;
};

constexpr int readable_width = 960;

}  // namespace

RgbImage overdraw_picture(const MethodRun& run) {
  static constexpr std::array<Rgb, 5> heat = {Rgb{40, 60, 150}, Rgb{150, 50, 140}, Rgb{225, 70, 60}, Rgb{250, 190, 70},
                                              Rgb{255, 255, 240}};
  const std::uint32_t max = *std::max_element(run.overdraw.begin(), run.overdraw.end());
  Magnified picture(run, readable_width);
  for (int y = 0; y < run.plan->height; ++y)
    for (int x = 0; x < run.plan->width; ++x)
      if (const std::uint32_t count = run.overdraw[run.shown.index(x, y)])
        picture.fill(x, y, 1, 1, along(heat, max > 1 ? std::log(count) / std::log(max) : 0));
  return picture.take();
}

RgbImage quadtree_picture(const MethodRun& run) {
  Magnified picture(run, readable_width);
  for (const visibility::Window& window : run.windows) {
    if (window.ended == visibility::WindowCase::divided) continue;
    static constexpr std::array<Rgb, 5> by_case = {nothing, Rgb{58, 60, 68}, Rgb{120, 190, 120}, Rgb{238, 170, 90},
                                                   decided};
    const Rgb color = by_case[static_cast<std::size_t>(window.ended)];
    const int right = std::min(window.x + window.size, run.plan->width),
              bottom = std::min(window.y + window.size, run.plan->height);
    for (int y = window.y; y < bottom; ++y)
      for (int x = window.x; x < right; ++x) {
        const visibility::SurfaceId shown = run.shown.opaque[run.shown.index(x, y)];
        const bool mixes = shown != visibility::no_surface && window.ended != visibility::WindowCase::pixel;
        const bool beside = shown == visibility::no_surface && window.ended == visibility::WindowCase::single;
        picture.fill(x, y, 1, 1,
                     mixes    ? mixed(color, color_of(shown), 0.35)
                     : beside ? mixed(color, nothing, 0.6)
                              : color);
      }
    if (window.size * picture.scale() > 2)
      picture.outline(window.x, window.y, right - window.x, bottom - window.y, line_color);
  }
  return picture.take();
}

RgbImage spans_picture(const MethodRun& run) {
  Magnified picture(run, readable_width);
  for (const visibility::SampleSpan& span : run.spans) {
    picture.fill(span.first, span.y, span.end - span.first, 1,
                 span.shown == visibility::no_surface ? decided : color_of(span.shown));
    if (picture.scale() > 2) picture.outline(span.first, span.y, span.end - span.first, 1, line_color);
    if (picture.scale() <= 2 && span.end - span.first > 2)
      picture.fill(span.first, span.y, 1, 1, mixed(color_of(span.shown), line_color, 0.5));
  }
  return picture.take();
}

RgbImage order_picture(const MethodRun& run) {
  static constexpr std::array<Rgb, 5> ramp = {Rgb{60, 45, 110}, Rgb{55, 95, 150}, Rgb{40, 150, 140}, Rgb{120, 200, 90},
                                              Rgb{250, 230, 90}};
  constexpr std::uint32_t none = ~0u;
  std::vector<std::uint32_t> piece_at(run.shown.opaque.size(), none);
  for (std::uint32_t i = 0; i < run.order.size(); ++i) {
    const visibility::Piece& piece = run.order[i];
    const visibility::Pieces::Bounds bounds = run.pieces.bounds_of(piece);
    for (int y = piece.box.first_y; y <= piece.box.last_y; ++y) {
      const visibility::Span span = run.pieces.columns_of(piece, bounds, y);
      for (int x = span.first; x < span.end; ++x) {
        const std::size_t pixel = run.shown.index(x, y);
        if (run.shown.opaque[pixel] == piece.surface) piece_at[pixel] = i;
      }
    }
  }
  Magnified picture(run, readable_width);
  const double last = std::max<double>(1, static_cast<double>(run.order.size()) - 1);
  for (int y = 0; y < run.plan->height; ++y)
    for (int x = 0; x < run.plan->width; ++x) {
      const std::uint32_t piece = piece_at[run.shown.index(x, y)];
      if (piece != none) picture.fill(x, y, 1, 1, along(ramp, piece / last));
      const auto separate = [&](int other_x, int other_y, bool upper) {
        if (other_x < 0 || other_y < 0 || picture.scale() < 2) return;
        const std::uint32_t other = piece_at[run.shown.index(other_x, other_y)];
        if (other == piece) return;
        const bool split = piece != none && other != none && run.order[piece].surface == run.order[other].surface;
        picture.outline(x, y, 1, 1, split ? decided : line_color, upper, !upper);
      };
      separate(x, y - 1, true);
      separate(x - 1, y, false);
    }
  return picture.take();
}

}  // namespace morphcl::hidden_surfaces
