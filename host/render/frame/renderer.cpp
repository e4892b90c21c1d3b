#include "morphcl/renderer.hpp"

#include <fmt/format.h>

#include "host/render/frame/frame_plan.hpp"
#include "host/render/frame/kernel_layout.hpp"
#include "morphcl/error.hpp"

namespace morphcl {

namespace {

// What frame buffers and kernels both state.
static_assert(FrameBuffer::tile_side == layout::tile && FrameBuffer::block_side == layout::tile_block);
static_assert(background_depth == layout::background_depth);

std::string shape(int width, int height, bool color, bool depth) {
  const char* const channels = color ? depth ? "RGBA and Z" : "RGBA alone" : depth ? "Z alone" : "no channels";
  return fmt::format("{} x {} pixels of {}", width, height, channels);
}

void require_fit(const FramePlan& plan, const FrameBuffer& frame) {
  if (frame.width() == plan.width && frame.height() == plan.height && frame.has_color() == plan.color &&
      frame.has_depth() == plan.depth)
    return;
  throw Error(ErrorKind::usage, "",
              fmt::format("the plan draws {}, but the frame buffer has {}",
                          shape(plan.width, plan.height, plan.color, plan.depth),
                          shape(frame.width(), frame.height(), frame.has_color(), frame.has_depth())));
}

}  // namespace

void Renderer::render(const Plan& plan, FrameBuffer& frame) {
  require_fit(*plan, frame);
  if (!plan->alone) {
    if (planner_ != 0 && planner_ != plan->planner)
      throw Error(
          ErrorKind::usage, "",
          "the plan is of another planner than those drawn before it; call forget() before another scene comes");
    planner_ = plan->planner;
  }
  draw(*plan, frame);
}

}  // namespace morphcl
