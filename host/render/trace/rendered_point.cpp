#include "host/render/trace/rendered_point.hpp"

#include <algorithm>

namespace morphcl {

const Draw* find_draw(const FramePlan& plan, std::size_t object) {
  const auto found =
      std::find_if(plan.draws.begin(), plan.draws.end(), [&](const Draw& draw) { return draw.object == object; });
  return found == plan.draws.end() ? nullptr : &*found;
}

float distance_of(const FramePlan& plan, float depth) {
  return plan.camera.parallel ? 0.0f - depth : plan.camera.near / depth;
}

std::optional<TraceRendered> rendered_vertex(const FramePlan& plan, const Draw& draw, std::size_t vertex) {
  const RasterGrid grid(plan.width, plan.height);
  const reference::Vertex found = reference::project_vertices(draw, plan, grid)[vertex];
  if (found.outcode != 0) return std::nullopt;
  TraceRendered rendered;
  rendered.clip = {found.clip.x, found.clip.y, found.clip.w};
  rendered.distance = plan.camera.parallel ? 0.0f - found.clip.z : found.clip.w;
  rendered.subpixel = {found.screen.x, found.screen.y};
  return rendered;
}

}  // namespace morphcl
