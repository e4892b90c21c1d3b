#include "demos/viewer/view_camera.hpp"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

#include "demos/viewer/matching_projection.hpp"
#include "morphcl/transform.hpp"

namespace morphcl::viewer {
namespace {

constexpr double kEyeStepsInDistance = 40.0;  // steps that move the eye as far as its distance to the target

// Where the shot's camera is at one frame.
struct Pose {
  glm::dvec3 eye, target;
  glm::dvec3 up;  // unit length
  Projection projection;
};

glm::dvec3 value_at(const Track& track, const glm::dvec3& constant, std::int64_t tick) {
  if (track.empty()) return constant;
  double value[3];
  track.evaluate(tick, value);
  return {value[0], value[1], value[2]};
}

// Of any length but 0, however small or large.
glm::dvec3 unit(const glm::dvec3& vector) {
  const double largest = std::max({std::abs(vector.x), std::abs(vector.y), std::abs(vector.z)});
  return glm::normalize(vector / largest);
}

Pose shot_pose(const Timeline& timeline, std::int64_t frame) {
  const FrameState all = evaluate(timeline, frame);
  const CameraState& state = all.camera;
  // The rows of a rigid transform are the camera's axes in the world.
  const glm::dmat3 axes = glm::transpose(glm::dmat3(state.world_to_eye));
  const Camera& camera = timeline.camera;
  if (camera.node >= 0) {
    // A camera in a node has no target: the point of its view axis nearest to the world's origin serves.
    const glm::dvec3 eye = -(axes * glm::dvec3(state.world_to_eye[3]));
    const double distance = std::max(glm::dot(axes[2], eye), near_distance(state.projection));
    return {eye, eye - std::max(distance, 1e-3) * axes[2], axes[1], state.projection};
  }
  const std::int64_t tick = timeline.time.frame_ticks(frame);
  const glm::dmat4 carrier = camera.parent < 0 ? glm::dmat4(1.0) : all.node_to_world[camera.parent];
  const glm::dvec3 own_up = value_at(camera.up_track, camera.up, tick);
  const glm::dvec3 up = state.up_replaced ? axes[1] : unit(glm::dmat3(carrier) * own_up);
  const auto in_world = [&carrier](const glm::dvec3& point) { return glm::dvec3(carrier * glm::dvec4(point, 1)); };
  return {in_world(value_at(camera.eye_track, camera.eye, tick)),
          in_world(value_at(camera.target_track, camera.target, tick)), up, state.projection};
}

Projection chosen_projection(const Pose& pose, ProjectionKind kind, const DemoSettings& settings, double aspect) {
  const double distance = glm::distance(pose.eye, pose.target);
  const bool parallel = kind == ProjectionKind::orthographic;
  if (parallel && settings.orthographic) return widened(*settings.orthographic, aspect);
  if (!parallel && settings.frustum) return widened(*settings.frustum, aspect);
  if (kind_of(pose.projection) == kind) return pose.projection;
  if (parallel) return matching_orthographic(pose.projection, distance, aspect);
  return matching_frustum(pose.projection, distance, aspect);
}

void move(Pose& pose, const View& view) {
  pose.eye += pose.up * (glm::distance(pose.eye, pose.target) * view.eye_steps / kEyeStepsInDistance);
  if (view.orbit_right == 0 && view.orbit_up == 0) return;

  const glm::dvec3 origin(0.0);
  const glm::dvec3 right = glm::cross(pose.target - pose.eye, pose.up);
  CompositeTransform orbit;
  orbit.rotate_about_axis(origin, right, -kOrbitStepDegrees * view.orbit_up)
      .rotate_about_axis(origin, pose.up, kOrbitStepDegrees * view.orbit_right);
  const glm::dmat3 rotation(orbit.matrix());
  pose.eye = pose.target + rotation * (pose.eye - pose.target);
  pose.up = rotation * pose.up;
}

// A scene that turns about the origin looks as from an eye that circles the other way.
void turn(Pose& pose, const Turning& turning, int ticks) {
  if (ticks == 0) return;
  CompositeTransform back;
  back.rotate_about_axis(glm::dvec3(0.0), turning.axis, -turning.degrees_a_tick * ticks);
  const glm::dmat3 rotation(back.matrix());
  pose.eye = rotation * pose.eye;
  pose.target = rotation * pose.target;
  pose.up = rotation * pose.up;
}

// What is parallel shows a smaller window, else the eye comes nearer.
void zoom(Pose& pose, Projection& projection, int steps, double aspect) {
  if (steps == 0) return;
  const double factor = std::exp2(-steps / kZoomSteps);
  const glm::dvec3 to_eye = pose.eye - pose.target;
  if (is_parallel(projection))
    projection = zoomed(projection, factor, aspect);
  else
    pose.eye = pose.target + factor * to_eye;
}

}  // namespace

ProjectionKind kind_of(const Projection& projection) {
  return is_parallel(projection) ? ProjectionKind::orthographic : ProjectionKind::frustum;
}

ProjectionKind shot_projection(const Timeline& timeline, std::int64_t frame) {
  return kind_of(evaluate(timeline, frame).camera.projection);
}

std::optional<Camera> view_camera(const Timeline& timeline, std::int64_t frame, const View& view,
                                  const DemoSettings& settings, double aspect) {
  Pose pose = shot_pose(timeline, frame);
  const bool moved =
      view.eye_steps != 0 || view.orbit_right != 0 || view.orbit_up != 0 || view.zoom != 0 || view.turn != 0;
  const bool own_projection =
      kind_of(pose.projection) == view.projection && !settings.orthographic && !settings.frustum;
  if (!moved && own_projection) return std::nullopt;

  Projection projection = chosen_projection(pose, view.projection, settings, aspect);
  move(pose, view);
  zoom(pose, projection, view.zoom, aspect);
  if (settings.turning) turn(pose, *settings.turning, view.turn);
  Camera camera;
  camera.projection = projection;
  camera.eye = pose.eye;
  camera.target = pose.target;
  camera.up = pose.up;
  return camera;
}

}  // namespace morphcl::viewer
