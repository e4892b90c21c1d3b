#include "host/render/explain/screen_reach.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "host/geometry/bounds.hpp"
#include "host/render/frame/kernel_layout.hpp"

namespace morphcl {

namespace {

struct Rectangle {
  double left, right, top, bottom;  // pixels
};

double row_times_point(const Row& row, const glm::dvec3& p) {
  return row[0] * p.x + row[1] * p.y + row[2] * p.z + row[3];
}

glm::dvec3 to_point(const std::array<float, 3>& p) { return {p[0], p[1], p[2]}; }

Rectangle rectangle_of(const Box& box, const Draw& draw, const FramePlan& plan) {
  const double width = plan.width, height = plan.height;
  Rectangle found{width, 0, height, 0};
  // Samples, and what a line covers beside it.
  const double around = 1 + (draw.shading == Shading::wireframe ? 0.75 / layout::subpixels * draw.line_width : 0);
  const glm::dvec3 pivot = draw.accuracy ? to_point(draw.accuracy->pivot) : glm::dvec3(0.0);
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 p = box.corner(corner) - pivot;
    const double w = row_times_point(draw.object_to_clip[3], p);
    if (!(w >= plan.camera.near_w * (1 + 1e-6) || plan.camera.parallel)) return {0, width, 0, height};
    const double x = (row_times_point(draw.object_to_clip[0], p) / w + 1) * 0.5 * width;
    const double y = (1 - row_times_point(draw.object_to_clip[1], p) / w) * 0.5 * height;
    if (!std::isfinite(x) || !std::isfinite(y)) return {0, width, 0, height};
    found = {std::min(found.left, x - around), std::max(found.right, x + around), std::min(found.top, y - around),
             std::max(found.bottom, y + around)};
  }
  return found;
}

// First and last tile of an interval of pixels; none when last < first.
struct Tiles {
  int first, last;
  Tiles(double from, double to, int count)
      : first(static_cast<int>(std::clamp(std::floor(from / layout::tile), 0.0, double{1.0} * count))),
        last(static_cast<int>(std::clamp(std::floor(to / layout::tile), -1.0, double{1.0} * count - 1))) {}
};

}  // namespace

ScreenReach find_reach(const FramePlan& plan) {
  ScreenReach reach;
  reach.tile_columns = (plan.width + layout::tile - 1) / layout::tile;
  reach.tile_rows = (plan.height + layout::tile - 1) / layout::tile;
  reach.reached.assign(static_cast<std::size_t>(reach.tile_columns) * reach.tile_rows, 0);
  std::unordered_map<const Mesh*, MorphBounds> bounds;
  for (const Draw& draw : plan.draws) {
    const MorphBounds& mesh = bounds.try_emplace(draw.mesh, *draw.mesh).first->second;
    std::vector<double> weights(draw.mesh->targets.size(), 0.0);
    for (const ActiveTarget& target : draw.targets) weights[target.target] = double{target.weight};
    const Box box = draw.displaced ? draw.displaced->box : mesh.at(weights);
    const Rectangle rectangle = rectangle_of(box, draw, plan);
    const Tiles columns(rectangle.left, rectangle.right, reach.tile_columns);
    const Tiles rows(rectangle.top, rectangle.bottom, reach.tile_rows);
    for (int row = rows.first; row <= rows.last; ++row)
      for (int column = columns.first; column <= columns.last; ++column)
        reach.reached[static_cast<std::size_t>(row) * reach.tile_columns + column] = 1;
  }
  for (int row = 0; row < reach.tile_rows; ++row) {
    const int height = std::min(layout::tile, plan.height - row * layout::tile);
    bool any = false;
    for (int column = 0; column < reach.tile_columns; ++column) {
      if (!reach.reached[static_cast<std::size_t>(row) * reach.tile_columns + column]) continue;
      any = true;
      ++reach.reached_tiles;
      reach.reached_pixels += static_cast<double>(height) * std::min(layout::tile, plan.width - column * layout::tile);
    }
    if (!any) reach.blank_rows += height;
  }
  return reach;
}

}  // namespace morphcl
