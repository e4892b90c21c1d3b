#include "host/render/reference/surface_visibility.hpp"

#include "host/visibility/paint.hpp"

namespace morphcl::reference {

using visibility::no_surface;
using visibility::PictureRows;
using visibility::ShownRows;

SurfaceVisibility::SurfaceVisibility(const FramePlan& plan, const RasterGrid& grid,
                                     const std::vector<std::vector<Vertex>>& vertices)
    : plan_(plan), grid_(grid), vertices_(vertices), surfaces_(plan, grid, vertices), pieces_(surfaces_.surfaces()) {
  switch (plan.visibility) {
    case VisibilityMethod::painter:
      back_to_front_ = visibility::sort_by_depth(pieces_, max_visibility_pieces).back_to_front;
      break;
    case VisibilityMethod::bsp: {
      visibility::Bsp tree = visibility::build_bsp(pieces_, max_visibility_pieces);
      for (const std::uint32_t i : tree.back_to_front()) back_to_front_.push_back(std::move(tree.pieces[i]));
      break;
    }
    case VisibilityMethod::warnock:
      whole_picture_.emplace(PictureRows{}, plan.width, plan.height);
      visibility::subdivide(surfaces_.surfaces(), *whole_picture_);
      break;
    case VisibilityMethod::watkins:
    case VisibilityMethod::z_buffer:
      break;
  }
}

SurfaceVisibility::~SurfaceVisibility() = default;

ShownRows SurfaceVisibility::find_shown(const Rows& rows) const {
  ShownRows shown({rows.first, rows.step}, plan_.width, plan_.height);
  if (whole_picture_) {
    const auto width = static_cast<std::size_t>(plan_.width);
    for (int y = rows.first; y < plan_.height; y += rows.step)
      std::copy_n(&whole_picture_->opaque[whole_picture_->index(0, y)], width, &shown.opaque[shown.index(0, y)]);
    for (const ShownRows::WithinError& of : whole_picture_->within_error) {
      const int x = static_cast<int>(of.pixel % width), y = static_cast<int>(of.pixel / width);
      if (shown.rows.next_from(y) == y) shown.within_error.push_back({shown.index(x, y), of.shown, of.by_planes});
    }
  } else if (plan_.visibility == VisibilityMethod::watkins) {
    visibility::scan_lines(surfaces_.surfaces(), shown);
  } else {
    visibility::paint(pieces_, back_to_front_, shown);
  }
  return shown;
}

std::vector<ShownRows::WithinError> SurfaceVisibility::find_visible(const Rows& rows, Visibility& visible) const {
  ShownRows shown = find_shown(rows);
  clear(plan_, rows, 1, visible);
  visible.pieces = surfaces_.pieces();
  for (int y = rows.first; y < plan_.height; y += rows.step)
    for (int x = 0; x < plan_.width; ++x) {
      const std::size_t pixel = visible.index(x, y);
      if (shown.opaque[pixel] != no_surface) visible.samples[pixel] = surfaces_.sample(shown.opaque[pixel], x, y);
    }
  if (surfaces_.has_lines()) add_lines(plan_, grid_, vertices_, visible);
  if (!plan_.blends) return std::move(shown.within_error);
  if (plan_.visibility == VisibilityMethod::warnock || plan_.visibility == VisibilityMethod::watkins) {
    find_layers(plan_, grid_, vertices_, visible);
    return std::move(shown.within_error);
  }
  const auto width = static_cast<std::size_t>(plan_.width);
  for (std::size_t i = shown.layers.size(); i-- > 0;) {
    const ShownRows::Layer& layer = shown.layers[i];
    const int x = static_cast<int>(layer.pixel % width),
              y = rows.first + static_cast<int>(layer.pixel / width) * rows.step;
    const Sample sample = surfaces_.sample(layer.surface, x, y);
    if (is_layer_in_front(plan_, sample, visible.samples[layer.pixel])) visible.layers.push_back({layer.pixel, sample});
  }
  // The pixels came from the last on, each from front to back.
  std::ranges::stable_sort(visible.layers, {}, &Layer::index);
  if (surfaces_.has_lines()) add_layers_of_lines(plan_, grid_, vertices_, visible);
  return std::move(shown.within_error);
}

}  // namespace morphcl::reference
