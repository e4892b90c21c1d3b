// The part of a glTF material that is drawn: base colour, opacity, sidedness and whether light matters; and its name.
#pragma once

#include "host/scene/gltf/gltf_document.hpp"
#include "host/scene/gltf/gltf_warnings.hpp"

namespace morphcl {

struct GltfMaterial {
  Material material;       // shading is smooth or unlit; white without a material, as the specification says
  bool has_alpha = false;  // false: alpha is 1 everywhere, whatever the vertices have
  bool seen = true;        // false: alpha is 0 everywhere, so there is nothing to draw
};

// `index` is -1 for a primitive without a material. What is wrong with one is a warning.
GltfMaterial read_material(const GltfDocument& document, int index, GltfWarnings& warnings);

}  // namespace morphcl
