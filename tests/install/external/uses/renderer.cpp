#include <morphcl/renderer.hpp>

#include <morphcl/planner.hpp>

bool use_renderer() {
  morphcl::Scene scene;
  const morphcl::Plan plan = morphcl::plan_frame(scene, 0);
  morphcl::FrameBuffer frame = plan.make_frame();
  morphcl::make_reference_renderer()->render(plan, frame);
  const auto by_turns = morphcl::make_auto_renderer({});
  by_turns->expect_frames(1);
  by_turns->render(plan, frame);
  return frame.depth_row(0)[0] == morphcl::background_depth && by_turns->drawn_by() == "reference";
}
