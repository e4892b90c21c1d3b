// A frame of the reference renderer, judged.
#pragma once

#include "host/render/frame/frame_plan.hpp"
#include "lab/frame_error/frame_difference.hpp"
#include "morphcl/planner.hpp"
#include "morphcl/renderer.hpp"

namespace morphcl::test {

// Draws `drawn` and compares it with the truth about `scene`: the same scene, or one that was changed on purpose.
inline accuracy::FrameDifference compare_frame(const Scene& scene, const Scene& drawn, std::int64_t frame,
                                               accuracy::Truth truth = accuracy::Truth::on_grid) {
  const Plan plan = plan_frame(drawn, frame);
  FrameBuffer pixels = plan.make_frame();
  make_reference_renderer()->render(plan, pixels);
  return accuracy::compare_with_fp64(scene, *plan, pixels, reference::shown_pixels(*plan), truth);
}

}  // namespace morphcl::test
