// How an object of a shot is placed and moves: its transform steps and the tracks of its node.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "host/scene/shot/shot_track.hpp"
#include "host/scene/shot/shot_value.hpp"
#include "morphcl/timeline.hpp"

namespace morphcl {

// Of one node. A point goes through the transform steps first, then through the tracks' scale, rotation and
// translation; rotations about x, y and z follow each other in this order.
class ObjectMotion {
 public:
  ObjectMotion(const ShotTable& object, TrackReader& tracks);

  // Takes the track whose target is `target`. False when it is none of node_targets.
  bool read_track(const ShotValue& target, const ShotTable& track, TrackReader& tracks, Node& node);
  // All tracks are read.
  void finish(Node& node);

  static const std::vector<std::string_view>& node_targets();

 private:
  AnimatedTransform transform_;
  std::array<Track, 3> axis_rotations_;  // about x, y, z
};

}  // namespace morphcl
