// A frame of the reference renderer, judged.
#pragma once

#include "host/render/plan/planner.hpp"
#include "host/render/reference/reference_renderer.hpp"
#include "lab/frame_error/frame_difference.hpp"

namespace morphcl::test {

// Draws `drawn` and compares it with the truth about `scene`: the same scene, or one that was changed on purpose.
inline accuracy::FrameDifference compare_frame(const Scene& scene, const Scene& drawn, std::int64_t frame,
                                               accuracy::Truth truth = accuracy::Truth::on_grid) {
  const FramePlan plan = plan_frame(drawn, frame);
  FrameBuffer pixels(plan.width, plan.height, plan.color, plan.depth);
  make_reference_renderer()->render(plan, pixels);
  return accuracy::compare_with_fp64(scene, plan, pixels, reference::shown_pixels(plan), truth);
}

}  // namespace morphcl::test
