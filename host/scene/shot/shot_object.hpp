// The [[object]] tables of a shot file.
#pragma once

#include <cstddef>
#include <string>
#include <unordered_set>

#include "host/scene/shot/mesh_library.hpp"
#include "host/scene/shot/parent_links.hpp"
#include "host/scene/shot/shot_track.hpp"
#include "host/scene/shot/shot_value.hpp"
#include "morphcl/scene.hpp"

namespace morphcl {

// Adds objects of a shot to a scene: nodes, objects and weights. Meshes stay in the library until all objects are read.
class ObjectReader {
 public:
  ObjectReader(MeshLibrary& library, TrackReader& tracks, ParentLinks& parents, Scene& scene)
      : library_(library), tracks_(tracks), parents_(parents), scene_(scene) {}

  // A node of its own carries the table's transform steps and tracks; the model's node tree hangs below it. The table's
  // shading, color and double_sided replace the model's where given. An object without a mesh is a group: its node
  // alone.
  void read(const ShotValue& object);

 private:
  std::string read_name(const ShotTable& table);
  void add_model(const ShotTable& table, const ImportedModel& model, int root, const std::string& name);
  void read_tracks(const ShotTable& object, int root, std::size_t first_object);
  bool read_color_track(const ShotValue& target, const ShotTable& track, std::size_t first_object);
  void make_elastic(const ShotValue& elastic, std::size_t first_object);
  void drive_morph(const ShotTable& track, const std::string& target, std::size_t first_object);

  MeshLibrary& library_;
  TrackReader& tracks_;
  ParentLinks& parents_;
  Scene& scene_;
  std::unordered_set<std::string> names_;
};

}  // namespace morphcl
