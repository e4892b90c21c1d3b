#include "morphcl/plan.hpp"

#include "host/render/frame/frame_plan.hpp"

namespace morphcl {

Plan::Plan(FramePlan plan) : plan_(std::make_shared<const FramePlan>(std::move(plan))) {}

std::int64_t Plan::frame() const { return plan_->frame; }
int Plan::width() const { return plan_->width; }
int Plan::height() const { return plan_->height; }
bool Plan::has_color() const { return plan_->color; }
bool Plan::has_depth() const { return plan_->depth; }

FramePlan Plan::operator*() && { return *plan_; }

FrameBuffer Plan::make_frame() const { return FrameBuffer(width(), height(), has_color(), has_depth()); }

FrameAttributes Plan::attributes() const {
  return {.frame = plan_->frame,
          .fps_numerator = plan_->fps_numerator,
          .fps_denominator = plan_->fps_denominator,
          .world_to_eye = plan_->world_to_eye,
          .world_to_ndc = plan_->world_to_ndc};
}

}  // namespace morphcl
