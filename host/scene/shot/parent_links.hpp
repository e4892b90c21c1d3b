// The key `parent` of the objects, lights and camera of a shot. It names an object, which may stand further down, so
// that names become nodes when all objects are read.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "host/scene/shot/shot_value.hpp"
#include "morphcl/timeline.hpp"

namespace morphcl {

class ParentLinks {
 public:
  // What names this object as its parent hangs below this node. Names are different.
  void add_named(const std::string& name, int node) { nodes_.emplace(name, node); }

  // `parent` is the value of the key; it outlives this.
  void hang_node(const ShotValue& parent, int node) { links_.push_back({parent, Child::node, node}); }
  void hang_light(const ShotValue& parent, std::size_t light) {
    links_.push_back({parent, Child::light, static_cast<int>(light)});
  }
  void hang_camera(const ShotValue& parent) { links_.push_back({parent, Child::camera, 0}); }

  // Sets the parents of nodes, the nodes of lights and the parent of the camera. Error(bad_input) at a key that names
  // no object, or an object that hangs below itself: the cycle's names are told, eight of them at most.
  void resolve(Timeline& timeline) const;

 private:
  enum class Child { node, light, camera };
  struct Link {
    ShotValue parent;
    Child child;
    int index;  // of the node or light
  };
  int named(const ShotValue& parent) const;
  void refuse_cycles(const std::vector<Node>& nodes) const;

  std::map<std::string, int> nodes_;
  std::vector<Link> links_;
};

}  // namespace morphcl
