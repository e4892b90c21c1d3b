#include "anim/timeline_at.hpp"

#include <fmt/core.h>

#include <cmath>
#include <string>

#include "host/math/direction.hpp"
#include "host/math/finite.hpp"
#include "morphcl/camera.hpp"
#include "morphcl/error.hpp"
#include "morphcl/rotation.hpp"

namespace morphcl {

namespace {

double sample(const Track& track, double constant, std::int64_t tick) {
  if (!track.empty()) track.evaluate(tick, &constant);
  return constant;
}

glm::dvec3 sample(const Track& track, glm::dvec3 constant, std::int64_t tick) {
  if (!track.empty()) track.evaluate(tick, &constant.x);
  return constant;
}

glm::dquat sample(const Track& track, const glm::dquat& constant, std::int64_t tick) {
  if (track.empty()) return constant;
  double xyzw[4];
  track.evaluate(tick, xyzw);
  return {xyzw[3], xyzw[0], xyzw[1], xyzw[2]};
}

Projection evaluate_projection(const Camera& camera, std::int64_t tick) {
  Projection projection = camera.projection;
  if (auto* perspective = std::get_if<Perspective>(&projection))
    perspective->fovy_degrees = sample(camera.fovy_track, perspective->fovy_degrees, tick);
  if (auto* perspective = std::get_if<HorizontalPerspective>(&projection))
    perspective->fovx_degrees = sample(camera.fovx_track, perspective->fovx_degrees, tick);
  std::visit(
      [&](auto& p) {
        p.near = sample(camera.near_track, p.near, tick);
        p.far = sample(camera.far_track, p.far, tick);
      },
      projection);
  validate(projection);
  return projection;
}

glm::dvec3 carried_point(const glm::dmat4& node, const glm::dvec3& point) {
  return glm::dvec3(node * glm::dvec4(point, 1));
}

LookAt evaluate_view(const Camera& camera, const glm::dmat4& node, std::int64_t tick) {
  if (camera.node >= 0) return look_along(glm::dvec3(node[3]), -glm::dvec3(node[2]), glm::dvec3(node[1]));
  const glm::dvec3 eye = sample(camera.eye_track, camera.eye, tick),
                   target = sample(camera.target_track, camera.target, tick),
                   up = sample(camera.up_track, camera.up, tick);
  if (camera.parent < 0) return look_at(eye, target, up);
  return look_at(carried_point(node, eye), carried_point(node, target), glm::dmat3(node) * up);
}

glm::dmat4 steps_at(const Node& node, std::int64_t tick) {
  try {
    return node.steps.at(tick).matrix();
  } catch (const Error& error) {
    throw Error(ErrorKind::bad_input, "", fmt::format("the transform of \"{}\": {}", node.name, error.message()));
  }
}

}  // namespace

std::int64_t tick_of(const TimeBase& time, std::int64_t frame) {
  if (frame > 1'000'000 || frame < -1'000'000)
    throw Error(ErrorKind::usage, "", fmt::format("frame {} is out of range; frames are -1000000 to 1000000", frame));
  return time.frame_ticks(frame);
}

glm::dmat4 node_to_parent(const Node& node, std::int64_t tick) {
  const glm::dvec3 translation = sample(node.translation_track, node.translation, tick);
  const glm::dmat3 rotation = rotation_matrix(sample(node.rotation_track, node.rotation, tick));
  const glm::dvec3 scale = sample(node.scale_track, node.scale, tick);
  glm::dmat4 matrix;
  for (int column = 0; column < 3; ++column) matrix[column] = glm::dvec4(rotation[column] * scale[column], 0);
  matrix[3] = glm::dvec4(translation, 1);
  return matrix * (node.steps.empty() ? node.static_transform : steps_at(node, tick));
}

bool moves_itself(const Node& node) {
  return !node.translation_track.empty() || !node.rotation_track.empty() || !node.scale_track.empty() ||
         node.steps.moves();
}

bool shows_itself(const Node& node, std::int64_t tick) { return sample(node.visible_track, 1.0, tick) >= 0.5; }

void require_finite(const glm::dmat4& node_to_world, const Node& node, std::size_t index) {
  if (!is_finite(node_to_world))
    throw Error(ErrorKind::bad_input, fmt::format("nodes[{}] {}", index, node.name),
                "the transform to world space overflows; use smaller numbers");
}

void evaluate_weights(const MorphWeights& morph, std::int64_t tick, std::vector<double>& weights) {
  weights.assign(morph.weights.begin(), morph.weights.end());
  for (const WeightTrack& driven : morph.tracks)
    if (!driven.track.empty()) driven.track.evaluate(tick, weights.data() + driven.first_target);
  for (std::size_t i = 0; i < weights.size(); ++i)
    if (!std::isfinite(weights[i]))
      throw Error(ErrorKind::bad_input, "weights", fmt::format("weight {} overflows; use smaller tangents", i));
}

int node_of(const Camera& camera) { return camera.node >= 0 ? camera.node : camera.parent; }

CameraState evaluate_camera(const Camera& camera, const glm::dmat4& node_to_world, std::int64_t tick) {
  try {
    const LookAt view = evaluate_view(camera, node_to_world, tick);
    return {evaluate_projection(camera, tick), view.world_to_eye, view.up_replaced};
  } catch (const Error& error) {
    throw Error(ErrorKind::bad_input, "camera", error.message());
  }
}

namespace {

SpotState evaluate_spot(const Light& light, const glm::dvec3& position, const glm::dmat4& node_to_world,
                        std::int64_t tick, const std::string& place) {
  const SpotBeam& spot = *light.spot;
  glm::dvec3 target = sample(spot.target_track, spot.target, tick);
  if (light.node >= 0) target = carried_point(node_to_world, target);
  if (!is_finite(target)) throw Error(ErrorKind::bad_input, place, "a value overflows; use smaller tangents");
  if (target == position)
    throw Error(ErrorKind::bad_input, place, "the spot light stands at its target; a beam needs a direction");
  return {unit(direction_from_to(position, target).high), spot.inner_cone_degrees, spot.outer_cone_degrees};
}

}  // namespace

LightState evaluate_light(const Light& light, std::size_t index, const glm::dmat4& node_to_world, std::int64_t tick) {
  glm::dvec3 vector = sample(light.vector_track, light.vector, tick);
  if (light.node >= 0)
    vector = light.kind == LightKind::point ? carried_point(node_to_world, vector) : glm::dmat3(node_to_world) * vector;
  const glm::dvec3 color = sample(light.color_track, light.color, tick);
  const std::string place = fmt::format("lights[{}]", index);
  if (!is_finite(vector) || !is_finite(color))
    throw Error(ErrorKind::bad_input, place, "a value overflows; use smaller tangents");
  if (light.kind == LightKind::point) {
    LightState state{light.kind, vector, color, light.falloff};
    if (light.spot) state.spot = evaluate_spot(light, vector, node_to_world, tick, place);
    return state;
  }
  if (vector == glm::dvec3(0))
    throw Error(ErrorKind::bad_input, place, "the direction is 0 0 0; it must point towards the light");
  return {light.kind, unit(vector), color, light.falloff};
}

}  // namespace morphcl
