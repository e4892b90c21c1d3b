#include <morphcl/solids.hpp>
#include <morphcl/trace.hpp>

bool use_trace() {
  morphcl::Scene scene;
  scene.add_object("cube", morphcl::make_cube());
  const morphcl::Trace trace = morphcl::trace(scene, 0, {.vertex = 1});
  return trace.pixel.has_value() && trace.stages.size() == 5 && !std::string(name_of(trace.stages[0].to)).empty();
}
