// Animations of a glTF file as tracks.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "host/scene/gltf/gltf_accessor.hpp"
#include "host/scene/gltf/gltf_nodes.hpp"
#include "host/scene/gltf/gltf_sampler.hpp"

namespace morphcl {

struct GltfAnimations {
  std::vector<GltfSampler> node_weights;  // one a node, an empty track where nothing drives its weights
  double duration_seconds = 0;            // of the last key
};

// Puts the tracks of the animation that `wanted` names into `nodes`; without it those of all animations if no two move
// the same value of a node, else those of the first, with a warning. `node_targets` holds the morph targets of each
// node's mesh, 0 without. All animations are listed in `parts`.
//
// Keys whose times fall on the same tick become one: the last of them. Rotation keys of step and linear samplers are
// scaled to unit length. Error(bad_input): times that decrease, counts that do not fit, wrong types, fewer than two
// keys for a cubic spline, a node with a matrix, weights of a node without targets. Error(usage): there is none of that
// name.
GltfAnimations read_animations(const GltfDocument& document, const GltfAccessors& accessors, const TimeBase& time,
                               const std::vector<std::size_t>& node_targets, const std::optional<std::string>& wanted,
                               GltfNodes& nodes, std::vector<ModelPart>& parts, GltfWarnings& warnings);

}  // namespace morphcl
