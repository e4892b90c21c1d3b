// What the raster sees of a frame: its triangles and lines in drawing order, clipped and snapped to sub-pixels.
#pragma once

#include <vector>

#include "host/render/frame/kernel_layout.hpp"
#include "host/render/reference/clip_polygon.hpp"
#include "host/render/reference/visibility.hpp"

namespace morphcl::reference {

struct PrimitiveIdentity {
  std::uint64_t order;  // of drawing, as in Sample
  std::uint32_t draw, primitive;
};

// Corners in the order that gives front faces a positive area.
struct ScreenTriangle {
  ScreenVertex a, b, c;
  bool double_sided;
  const Piece* piece;  // null: the whole triangle, as the mesh has it
};

// Half of what a line covers across its longer axis, in sub-pixels; `run` and `rise` along that axis and across it.
std::int64_t half_thickness(std::int64_t run, std::int64_t rise, std::uint32_t width);

struct ScreenLine {
  ScreenVertex from, to;
  std::uint32_t width;  // sub-pixels
  const Piece* piece;   // null: the whole line; else its ends are the first two corners
};

// visitor.triangle(ScreenTriangle, identity) and visitor.line(ScreenLine, identity), in drawing order.
template <class Visitor>
void for_each_screen_primitive(const FramePlan& plan, const RasterGrid& grid,
                               const std::vector<std::vector<Vertex>>& vertices, Visitor&& visitor) {
  std::uint64_t order = 0;
  for (std::uint32_t d = 0; d < plan.draws.size(); ++d) {
    const Draw& draw = plan.draws[d];
    const bool lines = draw.shading == Shading::wireframe;
    const std::vector<glm::uvec2> edges = lines ? wireframe_edges(*draw.mesh) : std::vector<glm::uvec2>();
    const std::size_t count = lines ? edges.size() : draw.mesh->triangles.size();
    // On the screen y points down: to give front faces a positive area, two corners change places.
    const int second = draw.mirrored ? 1 : 2, third = draw.mirrored ? 2 : 1;
    for (std::uint32_t p = 0; p < count; ++p, order += 8) {
      std::vector<const Vertex*> v;
      for (int i = 0; i < (lines ? 2 : 3); ++i)
        v.push_back(&vertices[d][lines ? edges[p][i] : draw.mesh->triangles[p][i]]);
      int some = 0, all = ~0;
      for (const Vertex* vertex : v) {
        some |= vertex->outcode;
        all &= vertex->outcode;
      }
      PrimitiveIdentity identity{order, d, p};
      if (some == 0) {
        if (lines)
          visitor.line(ScreenLine{v[0]->screen, v[1]->screen, draw.line_width, nullptr}, identity);
        else
          visitor.triangle({v[0]->screen, v[second]->screen, v[third]->screen, draw.double_sided, nullptr}, identity);
        continue;
      }
      if (all != 0 || (some & OUT_INVALID) != 0) continue;
      std::vector<Corner> corners;
      for (std::size_t i = 0; i < v.size(); ++i)
        corners.push_back({v[i]->clip, {i == 0 ? 1.0f : 0.0f, i == 1 ? 1.0f : 0.0f, i == 2 ? 1.0f : 0.0f}});
      corners = clip_polygon(std::move(corners), plan, grid);
      if (lines) {
        if (corners.size() != 2) continue;
        Piece piece{};
        for (int k = 0; k < 2; ++k) {
          piece.corner[k] = to_screen(corners[k].clip, grid, plan);
          std::copy(corners[k].weight, corners[k].weight + 3, piece.weight[k]);
        }
        visitor.line(ScreenLine{piece.corner[0], piece.corner[1], draw.line_width, &piece}, identity);
        continue;
      }
      for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
        Piece piece;
        const Corner* const fan[3] = {&corners[0], &corners[i], &corners[i + 1]};
        for (int k = 0; k < 3; ++k) {
          piece.corner[k] = to_screen(fan[k]->clip, grid, plan);
          std::copy(fan[k]->weight, fan[k]->weight + 3, piece.weight[k]);
        }
        identity.order = order + i;
        visitor.triangle({piece.corner[0], piece.corner[second], piece.corner[third], draw.double_sided, &piece},
                         identity);
      }
    }
  }
}

}  // namespace morphcl::reference
