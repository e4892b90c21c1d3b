// A glTF mesh: its primitives, and what they share.
#pragma once

#include <string>
#include <vector>

#include "host/scene/gltf/gltf_primitive.hpp"

namespace morphcl {

struct GltfMesh {
  std::vector<int> meshes;          // the primitives that are drawn: indices into the meshes made so far
  std::vector<Material> materials;  // one a primitive
  std::vector<double> weights;      // one a target: the mesh's own, else 0
  std::size_t primitive_count = 0;  // in the file
};

// Reads mesh `index` and appends what it draws to `meshes`; without `decode` it is only checked, all but its data.
// Error(bad_input) also for target counts that differ between primitives, and weights that are not one a target.
// Targets are named by extras.targetNames, else "target0", ...
GltfMesh read_mesh(const GltfDocument& document, const GltfAccessors& accessors, std::size_t index, bool decode,
                   std::vector<Mesh>& meshes, GltfWarnings& warnings);

}  // namespace morphcl
