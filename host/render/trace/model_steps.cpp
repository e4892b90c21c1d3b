#include "host/render/trace/model_steps.hpp"

#include <fmt/format.h>

#include "morphcl/rotation.hpp"

namespace morphcl {

namespace {

// What a node's tracks, or the constants beside them, say at a tick.
struct NodePose {
  glm::dvec3 translation;
  glm::dquat rotation;  // of any length
  glm::dvec3 scale;
};

NodePose pose_at(const Node& node, std::int64_t tick) {
  NodePose pose{node.translation, node.rotation, node.scale};
  if (!node.translation_track.empty()) node.translation_track.evaluate(tick, &pose.translation.x);
  if (!node.scale_track.empty()) node.scale_track.evaluate(tick, &pose.scale.x);
  if (node.rotation_track.empty()) return pose;
  double xyzw[4];
  node.rotation_track.evaluate(tick, xyzw);
  pose.rotation = {xyzw[3], xyzw[0], xyzw[1], xyzw[2]};
  return pose;
}

void add_pose(const NodePose& pose, CompositeTransform& steps) {
  if (pose.scale != glm::dvec3(1)) steps.scale(pose.scale);
  const glm::dmat4 rotation(rotation_matrix(pose.rotation));
  if (rotation != glm::dmat4(1)) {
    const glm::dquat& q = pose.rotation;
    steps.add_step({"rotate", fmt::format("by the quaternion ({:.6g}, {:.6g}, {:.6g}, {:.6g})", q.x, q.y, q.z, q.w),
                    rotation, glm::transpose(rotation), true});
  }
  if (pose.translation != glm::dvec3(0)) steps.translate(pose.translation);
}

}  // namespace

std::vector<TransformStep> model_steps(const std::vector<Node>& nodes, int node, std::int64_t tick) {
  std::vector<TransformStep> all;
  for (int i = node; i >= 0; i = nodes[static_cast<std::size_t>(i)].parent) {
    const Node& one = nodes[static_cast<std::size_t>(i)];
    CompositeTransform steps;
    if (one.static_transform != glm::dmat4(1)) steps.matrix_step(one.static_transform);
    add_pose(pose_at(one, tick), steps);
    const bool alone = i == node && one.parent < 0;
    for (TransformStep step : steps.steps()) {
      if (!alone && !one.name.empty()) step.detail += fmt::format(" (node {})", one.name);
      all.push_back(std::move(step));
    }
  }
  return all;
}

}  // namespace morphcl
