#include <morphcl/job.hpp>

bool use_job() {
  morphcl::Scene scene;
  scene.image.width = 8;
  scene.image.height = 8;
  const auto renderer = morphcl::make_reference_renderer();
  const morphcl::JobResult result = morphcl::run({.pattern = "use_job.#.exr", .frames = {0}}, scene, *renderer);
  return result.frames.size() == 1 && morphcl::fingerprint(scene).size() == 32;
}
