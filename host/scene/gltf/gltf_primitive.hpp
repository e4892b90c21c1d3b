// One primitive of a glTF mesh as a Mesh: attributes, morph targets, and its mode's indices as triangles or edges.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "host/scene/gltf/gltf_accessor.hpp"
#include "host/scene/gltf/gltf_warnings.hpp"

namespace morphcl {

struct GltfPrimitive {
  Mesh mesh;
  Material material;
};

// Nothing when there is nothing to draw: no POSITION, points, or no whole triangle or line; a warning says so. Nothing
// either without `decode`: then the primitive is only checked, all but its data.
std::optional<GltfPrimitive> read_primitive(const GltfDocument& document, const GltfAccessors& accessors,
                                            const GltfValue& json, const std::vector<std::string>& target_names,
                                            bool decode, GltfWarnings& warnings);

}  // namespace morphcl
