#include "demos/viewer/eye_lights.hpp"

#include <glm/glm.hpp>

namespace morphcl::viewer {

std::vector<Light> lights_before_eye(const Timeline& timeline, std::int64_t frame, const Camera& camera) {
  Timeline moved = timeline;
  moved.camera = camera;
  const FrameState before = evaluate(timeline, frame);
  const glm::dmat4 to_eye = before.camera.world_to_eye;
  const glm::dmat4 from_eye = glm::inverse(evaluate(moved, frame).camera.world_to_eye);
  std::vector<Light> lights;
  for (const LightState& state : before.lights) {
    const double w = state.kind == LightKind::point ? 1.0 : 0.0;
    Light light;
    light.kind = state.kind;
    light.vector = glm::dvec3(from_eye * (to_eye * glm::dvec4(state.vector, w)));
    light.color = state.color;
    light.falloff = state.falloff;
    if (state.spot) {
      const glm::dvec3 beam(from_eye * (to_eye * glm::dvec4(state.spot->beam, 0)));
      light.spot = SpotBeam{light.vector + beam, {}, state.spot->inner_cone_degrees, state.spot->outer_cone_degrees};
    }
    lights.push_back(light);
  }
  return lights;
}

}  // namespace morphcl::viewer
