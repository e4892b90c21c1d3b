#include <morphcl/explain.hpp>

bool use_explain() {
  morphcl::Scene scene;
  scene.frames = {{.first = 0, .last = 1}};
  const morphcl::Planner planner(scene);
  const morphcl::PlanReport report = morphcl::explain(planner, 1);
  return !report.notes.empty() && morphcl::exceeded_limit(report.memory, std::size_t{1} << 40).empty();
}
