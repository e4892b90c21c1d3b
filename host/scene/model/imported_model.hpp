// What an importer makes of a model file: meshes, the hierarchy and its animation, ready to be put into a Scene.
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "morphcl/mesh.hpp"
#include "morphcl/scene.hpp"
#include "morphcl/timeline.hpp"

namespace morphcl {

// What a model file may ask for. Every limit is checked before the memory is taken.
struct ImportLimits {
  bool allow_outside = false;                                // may read files outside the model's folder
  std::uint64_t max_vertices = std::uint64_t{1} << 27;       // of one mesh; also the corners and keys of one list
  std::uint64_t max_decoded_bytes = std::uint64_t{4} << 30;  // everything read and made for one model
  const std::atomic<bool>* stop = nullptr;                   // once set, ImportBudget throws Error(interrupted)
};

struct ImportedModel {
  std::vector<Mesh> meshes;
  std::vector<Object> objects;          // in the order they are drawn; may be empty
  std::vector<Node> nodes;              // parents may come in any order
  std::optional<Camera> camera;         // sits in a node
  std::optional<double> camera_aspect;  // width / height that its perspective was made for
  std::vector<Light> lights;
  double duration_seconds = 0;        // time of the last key; 0 when nothing moves
  std::vector<ModelPart> parts;       // what there is to choose from
  std::vector<std::string> warnings;  // one line each: what the file holds that is not drawn, or was mended
  std::string content_hash;           // ContentHash of every byte read, hex
  std::vector<std::string> inputs;    // paths of the files that were read
};

}  // namespace morphcl
