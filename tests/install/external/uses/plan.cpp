#include <morphcl/plan.hpp>

#include <morphcl/planner.hpp>

bool use_plan() {
  morphcl::Scene scene;
  scene.image.width = 16;
  const morphcl::Plan plan = morphcl::plan_frame(scene, 7);
  return plan.make_frame().width() == 16 && plan.attributes().frame == 7;
}
