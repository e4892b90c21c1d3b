// Import of glTF 2.0 (.gltf with external or embedded buffers, .glb) by the rules of its specification.
//
// Each primitive becomes one Mesh and, for every node that draws it, one Object. Nodes keep the file's order. Which
// animation, camera and scene are used the caller may choose; otherwise see gltf_animation.hpp, gltf_view.hpp, and the
// file's scene, else its first, else every root node. Quantised and sparse data is decoded in fp64 and rounded once.
// Files without normals are lit flat. What alpha hides altogether is left out.
//
// A skinned mesh stands where its vertices are, whatever its node: the joints would place it, and are not read yet.
// What is not drawn (skins, textures, ...) is named in one warning. Of the extensions that a file requires, those that
// change what is drawn where are refused; the rest is named.
//
// Strict about geometry and motion, tolerant about looks (normals, colours, materials), each with a warning.
// Errors: cannot_read when the file or one of its buffers cannot be read; bad_input, naming the JSON path ("model.gltf:
// accessors[3]: ..."), for everything that breaks a rule that the picture relies on: indices, counts, types, bounds,
// NaN or Inf, cycles, a buffer outside the model's folder, or more data than `limits` allows.
#pragma once

#include <string>

#include "host/scene/model/imported_model.hpp"
#include "host/scene/model/model_choice.hpp"
#include "morphcl/track.hpp"

namespace morphcl {

ImportedModel import_gltf(const std::string& path, const TimeBase& time, const ImportLimits& limits = {},
                          const ModelChoice& choice = {});

// Its camera and the nodes that move it alone: no meshes, objects or lights. Error(bad_input) when no drawn node holds
// a camera.
ImportedModel import_gltf_camera(const std::string& path, const TimeBase& time, const ImportLimits& limits,
                                 const ModelChoice& choice);

}  // namespace morphcl
