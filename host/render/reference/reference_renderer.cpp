#include <Imath/half.h>

#include "host/render/frame/frame_plan.hpp"
#include "host/render/reference/shade.hpp"
#include "morphcl/renderer.hpp"

namespace morphcl {

namespace {

class ReferenceRenderer : public Renderer {
 public:
  std::string name() const override { return "reference"; }

  // The samples of the picture.
  Memory memory() const override { return {.per_pixel = sizeof(reference::Sample) + 4, .fixed = 0}; }

 private:
  void draw(const FramePlan& plan, FrameBuffer& frame) override {
    const RasterGrid grid(plan.width, plan.height);
    std::vector<std::vector<reference::Vertex>> vertices;
    for (const Draw& draw : plan.draws) vertices.push_back(reference::project_vertices(draw, plan, grid));
    const reference::Visibility visible = reference::find_visible(plan, grid, vertices);

    for (int y = 0; y < plan.height; ++y)
      for (int x = 0; x < plan.width; ++x) {
        const reference::Sample& sample = visible.samples[static_cast<std::size_t>(y) * plan.width + x];
        const bool background = sample.order == reference::no_order;
        if (plan.color) {
          const glm::vec3 color = background ? glm::vec3(0.0f) : reference::shade(plan, visible, vertices, x, y);
          for (int c = 0; c < 3; ++c) frame.color_row(c, y)[x] = imath_float_to_half(color[c]);
          frame.color_row(3, y)[x] = imath_float_to_half(background ? 0.0f : 1.0f);
        }
        if (plan.depth)
          frame.depth_row(y)[x] = background ? background_depth : reference::eye_distance(plan, sample.depth);
      }
  }
};

}  // namespace

std::unique_ptr<Renderer> make_reference_renderer() { return std::make_unique<ReferenceRenderer>(); }

}  // namespace morphcl
