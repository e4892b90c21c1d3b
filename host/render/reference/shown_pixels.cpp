#include "host/render/reference/shown_pixels.hpp"

#include "host/render/reference/shade.hpp"
#include "morphcl/frame.hpp"

namespace morphcl::reference {

std::vector<ShownPixel> shown_pixels(const FramePlan& plan) {
  const RasterGrid grid(plan.width, plan.height);
  std::vector<std::vector<Vertex>> vertices;
  for (const Draw& draw : plan.draws) vertices.push_back(project_vertices(draw, plan, grid));
  const Visibility visible = find_visible(plan, grid, vertices);
  std::vector<ShownPixel> pixels;
  pixels.reserve(visible.samples.size());
  for (int y = 0; y < plan.height; ++y)
    for (int x = 0; x < plan.width; ++x) {
      const Sample& sample = visible.samples[pixels.size()];
      if (sample.order == no_order) {
        pixels.push_back({nothing_shown, 0, background_depth, glm::vec3(0)});
        continue;
      }
      const glm::vec3 color =
          plan.has_color() ? shade_centre(plan, visible, sample, vertices, x, y).color : glm::vec3(0);
      pixels.push_back({plan.draws[sample.draw].object, sample.primitive, eye_distance(plan, sample.depth), color});
    }
  return pixels;
}

}  // namespace morphcl::reference
