// The node hierarchy of a glTF file.
#pragma once

#include <vector>

#include "host/scene/gltf/gltf_document.hpp"
#include "host/scene/gltf/gltf_warnings.hpp"

namespace morphcl {

struct GltfNodes {
  std::vector<Node> nodes;         // in the file's order
  std::vector<bool> drawn;         // in the chosen scene
  std::vector<bool> has_matrix;    // instead of translation, rotation, scale
  std::vector<int> parents_first;  // every node, after its parent
};

// `scene` is the one that is drawn; -1 draws every root. Error(bad_input): a child out of range, a node with two
// parents, a cycle (its nodes are named), a node with both a matrix and translation, rotation or scale, a rotation of
// length 0, a node of a scene out of range. A scene that names a child draws it and what is below it, where its parents
// put it, with a warning.
GltfNodes read_nodes(const GltfDocument& document, int scene, GltfWarnings& warnings);

// node -> world of every node with nothing animated.
std::vector<glm::dmat4> rest_to_world(const GltfNodes& nodes);

// Whether a node or one above it has a translation, rotation or scale track.
std::vector<bool> moving_nodes(const GltfNodes& nodes);

}  // namespace morphcl
