// Import of glTF 2.0 (.gltf with external or embedded buffers, .glb) by the rules of its specification.
//
// Each primitive becomes one Mesh and, for every node that draws it, one Object. Nodes keep the file's order. All
// animations are merged, each from time 0; where two drive the same value the first wins, with a warning. Without
// `scene` the first scene is drawn, without scenes every root node. Quantised and sparse data is decoded in fp64 and
// rounded once. Files without normals are lit flat. Alpha is 1 unless the material's alphaMode is BLEND.
//
// What is not drawn (skins, textures, ...) is named in one warning. Extensions that the file requires and that are not
// known are refused.
//
// Errors: cannot_read when the file or one of its buffers cannot be read; bad_input, naming the JSON path ("model.gltf:
// accessors[3]: ..."), for everything that breaks a rule that the picture relies on: indices, counts, types, bounds,
// NaN or Inf, cycles, a buffer outside the model's folder, or more data than `limits` allows.
#pragma once

#include <string>

#include "host/scene/model/imported_model.hpp"
#include "morphcl/track.hpp"

namespace morphcl {

ImportedModel import_gltf(const std::string& path, const TimeBase& time, const ImportLimits& limits = {});

}  // namespace morphcl
