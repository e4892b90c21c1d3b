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

std::string shape(int width, int height, ChannelSet channels) {
  std::string names;
  int left = channels.size();
  for (const Channel channel : channels) {
    const char* const separator = names.empty() ? "" : left == 1 ? " and " : ", ";
    names += fmt::format("{}{}", separator, name_of(channel));
    --left;
  }
  if (channels.size() < 2) names = channels.empty() ? "no channels" : names + " alone";
  return fmt::format("{} x {} pixels of {}", width, height, names);
}

void require_fit(const FramePlan& plan, const FrameBuffer& frame) {
  if (frame.width() == plan.width && frame.height() == plan.height && frame.channels() == plan.channels) return;
  throw Error(
      ErrorKind::usage, "",
      fmt::format("the plan draws {}, but the frame buffer has {}", shape(plan.width, plan.height, plan.channels),
                  shape(frame.width(), frame.height(), frame.channels())));
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
