#include "host/scene/shot/object_motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <utility>

#include "host/scene/shot/shot_transform.hpp"

namespace morphcl {

namespace {

constexpr std::array<StepKind, 3> axis_steps = {StepKind::rotate_x_degrees, StepKind::rotate_y_degrees,
                                                StepKind::rotate_z_degrees};
constexpr std::array<std::string_view, 3> axis_targets = {"rotation_x_degrees", "rotation_y_degrees",
                                                          "rotation_z_degrees"};

bool is_tracked(const Track& track) { return !track.empty(); }

}  // namespace

ObjectMotion::ObjectMotion(const ShotTable& object, TrackReader& tracks) {
  object.for_each("transform", [&](const ShotValue& step) { read_transform_step(step, tracks, transform_); });
}

const std::vector<std::string_view>& ObjectMotion::node_targets() {
  static const std::vector<std::string_view> targets = {
      "translation", "rotation", "rotation_x_degrees", "rotation_y_degrees", "rotation_z_degrees", "scale", "visible"};
  return targets;
}

bool ObjectMotion::read_track(const ShotValue& target, const ShotTable& table, TrackReader& tracks, Node& node) {
  const std::string& name = target.text();
  const auto about_axis = std::ranges::find(axis_targets, name);
  if (about_axis != axis_targets.end())
    axis_rotations_[static_cast<std::size_t>(about_axis - axis_targets.begin())] = tracks.read(table, KeyValue::number);
  else if (name == "translation")
    node.translation_track = tracks.read(table, KeyValue::point);
  else if (name == "rotation")
    node.rotation_track = tracks.read(table, KeyValue::rotation);
  else if (name == "scale")
    node.scale_track = tracks.read(table, KeyValue::factor);
  else if (name == "visible")
    node.visible_track = tracks.read(table, KeyValue::flag);
  else
    return false;
  if (is_tracked(node.rotation_track) && std::ranges::any_of(axis_rotations_, is_tracked))
    target.fail("the object is turned by rotation and by an angle about an axis; keep one of the two");
  return true;
}

void ObjectMotion::finish(Node& node) {
  if (std::ranges::any_of(axis_rotations_, is_tracked)) {
    if (is_tracked(node.scale_track)) {  // scaled before it is turned
      AnimatedStep scale{StepKind::scale_about};
      scale.tracks.push_back({3, std::exchange(node.scale_track, Track())});
      transform_.add_step(std::move(scale));
    }
    for (std::size_t axis = 0; axis < axis_steps.size(); ++axis) {
      if (axis_rotations_[axis].empty()) continue;
      AnimatedStep turn{axis_steps[axis]};
      turn.tracks.push_back({0, std::move(axis_rotations_[axis])});
      transform_.add_step(std::move(turn));
    }
  }
  if (transform_.moves())
    node.steps = std::move(transform_);
  else
    node.static_transform = transform_.at(0).matrix();
}

}  // namespace morphcl
