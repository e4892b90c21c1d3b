#include <morphcl/planner.hpp>

bool use_planner() {
  morphcl::Scene scene;
  scene.objects.emplace_back().mesh = 3;
  try {
    const morphcl::Planner planner(scene);
  } catch (const std::exception&) {
    return true;  // there is no such mesh
  }
  return false;
}
