// The meshes of a shot: built in or from files, each made once however many objects use it.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "host/scene/model/content_hash.hpp"
#include "host/scene/model/imported_model.hpp"
#include "host/scene/shot/shot_value.hpp"
#include "morphcl/solids.hpp"
#include "morphcl/track.hpp"

namespace morphcl {

class MeshLibrary {
 public:
  // `shot` is the path of the shot file; files are seen from its folder and, unless `limits` allow more, must lie below
  // it. The built-in solids may have `max_vertices` together.
  MeshLibrary(std::string shot, const TimeBase& time, const ImportLimits& limits,
              long long max_vertices = max_solid_vertices);

  // The model that the keys mesh, segments, targets, profile, points and morph_to of an object's table ask for. A
  // built-in solid is a model of one mesh, one object and one node. In the model's objects, `mesh` is an index into the
  // meshes that take_meshes returns; its own list of meshes is empty. The reference holds as long as the library does.
  const ImportedModel& model(const ShotTable& object);

  // The camera that the keys model, name and animation of a camera's table ask for, with the nodes that move it.
  ImportedModel camera_model(const ShotTable& camera);

  const Mesh& mesh(int index) const { return meshes_[static_cast<std::size_t>(index)]; }
  std::vector<Mesh> take_meshes() { return std::move(meshes_); }
  const std::vector<std::string>& warnings() const { return warnings_; }
  const std::vector<ModelPart>& parts() const { return parts_; }      // of all models
  const std::vector<std::string>& inputs() const { return inputs_; }  // paths of the files that were read
  // Adds the content of every file that was read, in the order of reading.
  void add_to(ContentHash& hash) const;

 private:
  ImportedModel make(const ShotTable& object);  // without its morph_to
  ImportedModel make_built_in(const ShotTable& object);
  ImportedModel make_solid_model(const ShotValue& name, std::optional<Segments> segments, const ShotValue& place);
  ImportedModel import_file(const ShotTable& object);
  void add_shapes(const ShotTable& object, ImportedModel& model);
  ImportedModel make_shape(const ShotTable& object, const ShotValue& shape);
  void charge(long long vertices, const ShotValue& place);
  void take_notes(const ImportedModel& model, const std::string& name);
  std::string existing_file(const ShotValue& reference) const;

  std::string shot_;
  TimeBase time_;
  ImportLimits limits_;
  long long max_vertices_, vertices_left_;
  std::map<std::string, ImportedModel> models_;  // by what was asked for
  std::vector<Mesh> meshes_;
  std::vector<ModelPart> parts_;
  std::vector<std::string> warnings_, inputs_, hashes_;
};

}  // namespace morphcl
