#include "morphcl/plan.hpp"

#include "host/render/frame/frame_plan.hpp"

namespace morphcl {

Plan::Plan(FramePlan plan) : plan_(std::make_shared<const FramePlan>(std::move(plan))) {}

std::int64_t Plan::frame() const { return plan_->frame; }
int Plan::width() const { return plan_->width; }
int Plan::height() const { return plan_->height; }
ChannelSet Plan::channels() const { return plan_->channels; }

FramePlan Plan::operator*() && { return *plan_; }

FrameBuffer Plan::make_frame() const { return FrameBuffer(width(), height(), channels()); }

FrameAttributes Plan::attributes() const {
  return {.frame = plan_->frame,
          .fps_numerator = plan_->fps_numerator,
          .fps_denominator = plan_->fps_denominator,
          .world_to_eye = plan_->world_to_eye,
          .world_to_ndc = plan_->world_to_ndc,
          .channel_names = plan_->channel_names,
          .manifests = plan_->manifests};
}

}  // namespace morphcl
