#include <Imath/half.h>

#include <array>
#include <cstdint>
#include <vector>

#include "host/render/frame/frame_plan.hpp"
#include "host/render/reference/shade.hpp"
#include "morphcl/renderer.hpp"

namespace morphcl {

namespace {

// The halves of a surface's colour, and of alpha.
std::array<std::uint16_t, 4> opaque_pixel(const glm::vec3& color) {
  return {imath_float_to_half(color.r), imath_float_to_half(color.g), imath_float_to_half(color.b),
          imath_float_to_half(1.0f)};
}

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

    for (int y = 0; y < plan.height; ++y) {
      const BackgroundRow behind = plan.background ? (*plan.background)[static_cast<std::size_t>(y)] : BackgroundRow{};
      for (int x = 0; x < plan.width; ++x) {
        const reference::Sample& sample = visible.samples[static_cast<std::size_t>(y) * plan.width + x];
        const bool background = sample.order == reference::no_order;
        if (plan.color) {
          const BackgroundRow pixel =
              background ? behind : opaque_pixel(reference::shade(plan, visible, vertices, x, y));
          for (int c = 0; c < 4; ++c) frame.color_row(c, y)[x] = pixel[static_cast<std::size_t>(c)];
        }
        if (plan.depth)
          frame.depth_row(y)[x] = background ? background_depth : reference::eye_distance(plan, sample.depth);
      }
    }
  }
};

}  // namespace

std::unique_ptr<Renderer> make_reference_renderer() { return std::make_unique<ReferenceRenderer>(); }

}  // namespace morphcl
